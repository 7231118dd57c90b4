package org.pendant.controller.builtin;

import org.pendant.controller.box.ControlBox;
import org.pendant.controller.io.RegisterDirection;
import org.pendant.controller.io.RegisterIo;
import org.pendant.controller.io.RegisterKind;
import org.pendant.language.signature.Type;
import org.pendant.script.function.Builtins;
import org.pendant.script.function.Call;
import org.pendant.script.function.Declaration;
import org.pendant.script.function.Effect;
import org.pendant.script.function.Outcome;
import org.pendant.script.value.ScriptError;

/** General-purpose registers (manual 18.32 to 18.37, 18.67 to 18.69). */
final class RegisterBuiltins {
  private RegisterBuiltins() {}

  static void declareIn(Builtins<ControlBox> builtins) {
    declareReading(builtins, RegisterDirection.INPUT, "18.32", "18.33", "18.34");
    declareReading(builtins, RegisterDirection.OUTPUT, "18.35", "18.36", "18.37");
    write(builtins, RegisterKind.BOOLEAN, "18.67", Type.BOOL)
        .doc("Writes a boolean output register, 0 to 127; registers outlive the program.")
        .does(RegisterBuiltins::setBool);
    write(builtins, RegisterKind.FLOAT, "18.68", Type.NUMBER)
        .doc("Writes a float output register, 0 to 47; registers outlive the program.")
        .does(RegisterBuiltins::setFloating);
    write(builtins, RegisterKind.INTEGER, "18.69", Type.INT)
        .doc("Writes an integer output register, 0 to 47; registers outlive the program.")
        .does(RegisterBuiltins::setInteger);
  }

  private static void declareReading(
      Builtins<ControlBox> builtins,
      RegisterDirection direction,
      String booleanSection,
      String floatSection,
      String integerSection) {
    String registers = direction.text() + " register";
    read(builtins, direction, RegisterKind.BOOLEAN, booleanSection, Type.BOOL)
        .doc("The value of a boolean " + registers + ", 0 to 127.")
        .does(
            call ->
                call.answer(registers(call, direction).bool(address(call, RegisterKind.BOOLEAN))));
    read(builtins, direction, RegisterKind.FLOAT, floatSection, Type.NUMBER)
        .doc("The value of a float " + registers + ", 0 to 47.")
        .does(
            call ->
                call.answer(
                    registers(call, direction).floating(address(call, RegisterKind.FLOAT))));
    read(builtins, direction, RegisterKind.INTEGER, integerSection, Type.INT)
        .doc("The value of an integer " + registers + ", 0 to 47.")
        .does(
            call ->
                call.answerInt(
                    registers(call, direction).integer(address(call, RegisterKind.INTEGER))));
  }

  private static Declaration<ControlBox> read(
      Builtins<ControlBox> builtins,
      RegisterDirection direction,
      RegisterKind kind,
      String section,
      Type result) {
    return builtins
        .declare("read_" + direction.text() + "_" + kind.text() + "_register")
        .manual("interfaces", section)
        .needs("address", Type.INT)
        .returns(result)
        .effect(Effect.ASKS);
  }

  private static Declaration<ControlBox> write(
      Builtins<ControlBox> builtins, RegisterKind kind, String section, Type type) {
    return builtins
        .declare("write_output_" + kind.text() + "_register")
        .manual("interfaces", section)
        .needs("address", Type.INT)
        .needs("value", type)
        .effect(Effect.TELLS);
  }

  private static RegisterIo registers(Call<ControlBox> call, RegisterDirection direction) {
    return call.host().signals().registers(direction);
  }

  private static int address(Call<ControlBox> call, RegisterKind kind) throws ScriptError {
    return call.integer(0, 0, kind.size() - 1);
  }

  private static Outcome setBool(Call<ControlBox> call) throws ScriptError {
    registers(call, RegisterDirection.OUTPUT)
        .setBool(address(call, RegisterKind.BOOLEAN), call.bool(1));
    return call.answer();
  }

  private static Outcome setFloating(Call<ControlBox> call) throws ScriptError {
    registers(call, RegisterDirection.OUTPUT)
        .setFloating(address(call, RegisterKind.FLOAT), call.number(1));
    return call.answer();
  }

  private static Outcome setInteger(Call<ControlBox> call) throws ScriptError {
    registers(call, RegisterDirection.OUTPUT)
        .setInteger(address(call, RegisterKind.INTEGER), call.integer(1));
    return call.answer();
  }
}
