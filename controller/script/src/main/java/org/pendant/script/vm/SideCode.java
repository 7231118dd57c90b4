package org.pendant.script.vm;

/**
 * Side code: an expression or assignment that was compiled for one place of a program, to run on
 * the side.
 *
 * @param function its code, for the slots of the function around the place
 * @param tables those of the program, with what the code adds
 * @param statics the constants that it adds
 * @param changing whether running it may change the content of lists, matrices or structs
 * @param result the operand of the slot that holds the result, or the variable that was assigned
 */
record SideCode(
    ScriptFunction function,
    Program.Tables tables,
    StaticSlots statics,
    boolean changing,
    int result) {

  /** The slot of the result in a call whose slots begin at {@code base}. */
  int resultSlot(int base) {
    return Instruction.isLocal(result) ? base + Instruction.index(result) : result;
  }
}
