/** What must hold; the error that says what does not is the program's last word. */
export function check(condition, message) {
  if (!condition) throw new Error(message);
}

/** Runs a program: exit code 0, or 1 and the reason in one line. */
export async function run(name, main) {
  try {
    console.log(await main(process.argv.slice(2)));
  } catch (error) {
    console.error(`${name}: ${error.message}`);
    process.exitCode = 1;
  }
}
