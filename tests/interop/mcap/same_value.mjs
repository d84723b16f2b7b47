// Decoded values against the text of others. Numbers are compared as what they are: integers of 64 bit exactly,
// floating-point numbers bit for bit.

const kNotFinite = { nan: NaN, inf: Infinity, "-inf": -Infinity };
const kBigIntegers = ["int64", "uint64"];
const kFloats = ["float32", "float64"];

/** What `text` must be for a scalar field, as a check: undefined where it is that, else what it should have been. */
export function scalarDifference(schema, field, actual, text) {
  const expected = (holds, wanted) => (holds ? undefined : `${text}, by others ${wanted}`);
  if (field.enumType) {
    const literal = schema.literal(field.enumType, actual);
    return expected(literal != undefined && text === literal, literal);
  }
  if (kFloats.includes(field.type)) {
    const number = text in kNotFinite ? kNotFinite[text] : text === "" ? undefined : Number(text);
    const same = field.type === "float32" ? Math.fround(number) : number;
    return expected(Object.is(same, actual), actual);
  }
  if (kBigIntegers.includes(field.type)) {
    return expected(typeof actual === "bigint" && /^-?\d+$/.test(text) && BigInt(text) === actual, actual);
  }
  return expected(text === String(actual), actual);
}

/** Text of JSON with each number as { number: "<its text>" }: JavaScript's own would round it. */
export function parseJson(text) {
  const tokens = /("(?:[^"\\]|\\.)*")|(-?\d+(?:\.\d+)?(?:[eE][+-]?\d+)?)/g;
  return JSON.parse(text.replace(tokens, (token, string) => (string ? token : `{"number":"${token}"}`)));
}

function jsonScalarDifference(schema, field, actual, json) {
  if (field.type === "bool") return json === actual ? undefined : `${json}, by others ${actual}`;
  const isNumber = !field.enumType && field.type !== "string" && !(kFloats.includes(field.type) && !Number.isFinite(actual));
  const text = isNumber ? json?.number : json;
  if (typeof text !== "string") return `${JSON.stringify(json)}: not ${isNumber ? "a number" : "a text"}`;
  return scalarDifference(schema, field, actual, text);
}

function jsonListDifference(schema, field, actual, json, path) {
  if (!Array.isArray(json) || json.length !== actual.length) return `${path}: ${json?.length} elements, by others ${actual.length}`;
  const [, ...inner] = field.arrayLengths ?? [];
  const element = { ...field, isArray: inner.length > 0, arrayLengths: inner };
  for (let i = 0; i < json.length; ++i) {
    const found = jsonFieldDifference(schema, element, actual[i], json[i], `${path}[${i}]`);
    if (found != undefined) return found;
  }
  return undefined;
}

function jsonFieldDifference(schema, field, actual, json, path) {
  if (field.isArray) return jsonListDifference(schema, field, actual, json, path);
  if (field.isComplex) return jsonStructDifference(schema, field.type, actual, json, `${path}.`);
  const found = jsonScalarDifference(schema, field, actual, json);
  return found == undefined ? undefined : `${path}: ${found}`;
}

/** Where a decoded struct and its JSON (of parseJson) differ; undefined where they do not. */
export function jsonStructDifference(schema, name, actual, json, prefix = "") {
  const fields = schema.fields(name);
  const names = fields.map((field) => field.name).join(" ");
  const found = Object.keys(json ?? {}).join(" ");
  if (names !== found) return `${prefix}: fields ${found}, by others ${names}`;
  for (const field of fields) {
    const difference = jsonFieldDifference(schema, field, actual[field.name], json[field.name], prefix + field.name);
    if (difference != undefined) return difference;
  }
  return undefined;
}
