package org.pendant.script.vm;

import org.pendant.script.value.MatrixValue;
import org.pendant.script.value.NumberList;
import org.pendant.script.value.Registers;
import org.pendant.script.value.ScriptError;
import org.pendant.script.value.Value;

/**
 * Translated code: a function whose instructions were translated to bytecode of the JVM; {@link
 * Translator} makes its subclasses.
 *
 * <p>All state stays where the {@link Processor} has it, in the registers and in the frames of the
 * thread. So both forms of a function can take over from each other at every instruction that a
 * thread may stop behind. A subclass has no fields and serves all runs of the program.
 */
abstract class TranslatedCode {
  /**
   * Runs the innermost frame of {@code thread}, and the frames it calls, until it returns or stops.
   *
   * @param base the first slot of the frame
   * @param pc the instruction to continue with: the first, the target of a loop, a call, or the one
   *     after an instruction that stopped the thread or called a function
   * @return {@link Processor.Stop#RETURNED} when this frame is gone and the caller's continues
   */
  abstract Processor.Stop run(Processor processor, ScriptThread thread, int base, int pc)
      throws ScriptError;

  static IllegalStateException unknown(int pc) {
    return new IllegalStateException("no thread can stop before instruction " + pc);
  }

  /** The list that holds a number at {@code index}; null when {@code object} is no such list. */
  static NumberList numbersAt(Value object, double index) {
    return object instanceof NumberList list && list.hasNumberAt((int) index) ? list : null;
  }

  /** The matrix that has an element in a row and column; null when {@code object} is none such. */
  static MatrixValue matrixAt(Value object, double row, double column) {
    return object instanceof MatrixValue matrix && matrix.has(row, column) ? matrix : null;
  }

  /** Stores a number in a list of numbers; false when that is not all there is to do. */
  static boolean storeAt(Value object, double index, int tag, double number) {
    int i = (int) index;
    if (object instanceof NumberList list
        && i >= 0
        && i < list.length()
        && !list.shared()
        && (list.tag() == tag || (list.tag() == Registers.FLOAT && tag == Registers.INT))) {
      list.setNumberAt(i, number);
      return true;
    }
    return false;
  }

  /** Stores a number in a matrix of numbers; false when that is not all there is to do. */
  static boolean storeAt(Value object, double row, double column, int tag, double number) {
    if (object instanceof MatrixValue matrix
        && row >= 0
        && row < matrix.rows()
        && column >= 0
        && column < matrix.columns()
        && !matrix.shared()
        && (matrix.tag() == tag || (matrix.tag() == Registers.FLOAT && tag == Registers.INT))) {
      matrix.setNumberAt((int) row, (int) column, number);
      return true;
    }
    return false;
  }
}
