// The IDL text of an MCAP schema as Foxglove's parser and reader understand it.
import { parseIDL } from "@foxglove/omgidl-parser";
import { MessageReader } from "@foxglove/omgidl-serialization";
import { check } from "./check.mjs";

export class Schema {
  #reader;
  #definitions = new Map();

  constructor(schema) {
    check(schema?.encoding === "omgidl", `schema ${schema?.name}: encoding ${schema?.encoding}`);
    const definitions = parseIDL(new TextDecoder().decode(schema.data));
    this.name = schema.name;
    this.#reader = new MessageReader(schema.name, definitions);
    for (const definition of definitions) this.#definitions.set(definition.name, definition);
  }

  decode(data) {
    return this.#reader.readMessage(data);
  }

  /** The fields of the message, or of a struct of another name. */
  fields(name = this.name) {
    const definition = this.#definitions.get(name);
    check(definition?.aggregatedKind === "struct", `${name} is no struct of the schema`);
    return definition.definitions;
  }

  /** The literal of an enum's value. */
  literal(enumType, value) {
    return this.#definitions.get(enumType).definitions.find((literal) => literal.value === value)?.name;
  }

  /**
   * The columns of a table, in its order: { path, field, value(message) }, undefined for what a message has not. A
   * sequence has its length and its first `elements` elements.
   */
  columns(elements) {
    return this.#columnsOf(this.fields(), "", (message) => message, elements);
  }

  #columnsOf(fields, prefix, get, elements) {
    return fields.flatMap((field) => {
      const value = (message) => get(message)?.[field.name];
      return this.#columnsOfField({ ...field, isArray: false }, field, prefix + field.name, value, elements);
    });
  }

  #columnsOfField(element, field, path, get, elements) {
    if (!field.isArray) {
      if (!field.isComplex) return [{ path, field, value: get }];
      return this.#columnsOf(this.fields(field.type), `${path}.`, get, elements);
    }
    const [size, ...inner] = field.arrayLengths ?? [Math.min(elements, field.arrayUpperBound ?? elements)];
    const rest = inner.length > 0 ? { ...field, arrayLengths: inner } : element;
    const columns = field.arrayLengths ? [] : [{ path: `${path}.length`, field: { type: "uint32" }, value: (m) => get(m)?.length }];
    for (let i = 0; i < size; ++i) {
      columns.push(...this.#columnsOfField(element, rest, `${path}[${i}]`, (m) => get(m)?.[i], elements));
    }
    return columns;
  }
}
