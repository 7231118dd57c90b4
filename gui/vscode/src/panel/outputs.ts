/** Outputs that can be switched from the panel, and by which function. */

const FUNCTIONS: { readonly [bank: string]: string } = {
  digital_out: 'set_standard_digital_out',
  configurable_out: 'set_configurable_digital_out',
  tool_out: 'set_tool_digital_out',
};

/** The expression that switches an output; undefined for signals that programs cannot set. */
export function switching(bank: string, index: number, on: boolean): string | undefined {
  const name = FUNCTIONS[bank];
  return name === undefined ? undefined : `${name}(${index}, ${on ? 'True' : 'False'})`;
}
