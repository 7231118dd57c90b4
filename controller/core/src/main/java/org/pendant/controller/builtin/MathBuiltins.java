package org.pendant.controller.builtin;

import static org.pendant.controller.builtin.BuiltinTexts.text;

import org.pendant.controller.box.ControlBox;
import org.pendant.language.signature.Type;
import org.pendant.language.signature.Unit;
import org.pendant.script.function.Builtins;
import org.pendant.script.function.Call;
import org.pendant.script.function.Effect;
import org.pendant.script.function.Outcome;
import org.pendant.script.value.ScriptError;

/** Functions of plain numbers (manual 17). */
final class MathBuiltins {
  private static final double DEGREES_PER_HALF_TURN = 180;

  private MathBuiltins() {}

  static void declareIn(Builtins<ControlBox> builtins) {
    declareTrigonometry(builtins);
    declareRounding(builtins);
    declarePowers(builtins);
  }

  private static void declareTrigonometry(Builtins<ControlBox> builtins) {
    builtins
        .declare("acos")
        .manual("urmath", "17.1")
        .doc("The arc cosine of f, 0 to pi. It is an error when f is not within -1 to 1.")
        .needs("f", Type.NUMBER)
        .returns(Unit.RADIAN)
        .effect(Effect.COMPUTES)
        .does(call -> call.answer(Math.acos(withinOne(call))));
    builtins
        .declare("asin")
        .manual("urmath", "17.2")
        .doc("The arc sine of f, -pi/2 to pi/2. It is an error when f is not within -1 to 1.")
        .needs("f", Type.NUMBER)
        .returns(Unit.RADIAN)
        .effect(Effect.COMPUTES)
        .does(call -> call.answer(Math.asin(withinOne(call))));
    builtins
        .declare("atan")
        .manual("urmath", "17.3")
        .doc("The arc tangent of f, -pi/2 to pi/2.")
        .needs("f", Type.NUMBER)
        .returns(Unit.RADIAN)
        .effect(Effect.COMPUTES)
        .does(call -> call.answer(Math.atan(call.number(0))));
    builtins
        .declare("atan2")
        .manual("urmath", "17.4")
        .doc(
            "The angle whose tangent is x/y, -pi to pi, in the quadrant that the signs of both"
                + " tell. Other languages call the first argument y.")
        .needs("x", Type.NUMBER)
        .needs("y", Type.NUMBER)
        .returns(Unit.RADIAN)
        .effect(Effect.COMPUTES)
        .does(call -> call.answer(Math.atan2(call.number(0), call.number(1))));
    builtins
        .declare("cos")
        .manual("urmath", "17.7")
        .doc("The cosine of the angle f.")
        .needs("f", Unit.RADIAN)
        .returns(Type.NUMBER)
        .effect(Effect.COMPUTES)
        .does(call -> call.answer(Math.cos(call.number(0))));
    builtins
        .declare("d2r")
        .manual("urmath", "17.8")
        .doc("Converts an angle from degrees to radians.")
        .needs("d", Unit.DEGREE)
        .returns(Unit.RADIAN)
        .effect(Effect.COMPUTES)
        .does(call -> call.answer(call.number(0) / DEGREES_PER_HALF_TURN * Math.PI));
    builtins
        .declare("r2d")
        .manual("urmath", "17.26")
        .doc("Converts an angle from radians to degrees.")
        .needs("r", Unit.RADIAN)
        .returns(Unit.DEGREE)
        .effect(Effect.COMPUTES)
        .does(call -> call.answer(call.number(0) / Math.PI * DEGREES_PER_HALF_TURN));
    builtins
        .declare("sin")
        .manual("urmath", "17.30")
        .doc("The sine of the angle f.")
        .needs("f", Unit.RADIAN)
        .returns(Type.NUMBER)
        .effect(Effect.COMPUTES)
        .does(call -> call.answer(Math.sin(call.number(0))));
    builtins
        .declare("tan")
        .manual("urmath", "17.33")
        .doc("The tangent of the angle f.")
        .needs("f", Unit.RADIAN)
        .returns(Type.NUMBER)
        .effect(Effect.COMPUTES)
        .does(call -> call.answer(Math.tan(call.number(0))));
  }

  private static void declareRounding(Builtins<ControlBox> builtins) {
    builtins
        .declare("ceil")
        .manual("urmath", "17.6")
        .doc("The smallest int that is not less than f. It is an error when no int is.")
        .needs("f", Type.NUMBER)
        .returns(Type.INT)
        .effect(Effect.COMPUTES)
        .does(call -> call.answerInt(rounded(call, Math.ceil(call.number(0)))));
    builtins
        .declare("floor")
        .manual("urmath", "17.9")
        .doc("The largest int that is not greater than f. It is an error when no int is.")
        .needs("f", Type.NUMBER)
        .returns(Type.INT)
        .effect(Effect.COMPUTES)
        .does(call -> call.answerInt(rounded(call, Math.floor(call.number(0)))));
    builtins
        .declare("random")
        .manual("urmath", "17.27")
        .doc(
            "A random number from 0 up to but without 1. The numbers follow from the controller's"
                + " seed, so runs with the same seed are alike.")
        .returns(Type.NUMBER)
        .does(call -> call.answer(call.host().environment().random().nextDouble()));
  }

  private static void declarePowers(Builtins<ControlBox> builtins) {
    builtins
        .declare("log")
        .manual("urmath", "17.16")
        .doc(
            "The logarithm of f to the base b. It is an error when one of them is negative, or when"
                + " b is 1.")
        .needs("b", Type.NUMBER)
        .needs("f", Type.NUMBER)
        .returns(Type.NUMBER)
        .effect(Effect.COMPUTES)
        .does(MathBuiltins::log);
    builtins
        .declare("pow")
        .manual("urmath", "17.25")
        .doc(
            "Raises base to the power of exponent. It is an error when base is negative and"
                + " exponent has a fraction, or when base is 0 and exponent negative.")
        .needs("base", Type.NUMBER)
        .needs("exponent", Type.NUMBER)
        .returns(Type.NUMBER)
        .effect(Effect.COMPUTES)
        .does(MathBuiltins::pow);
    builtins
        .declare("sqrt")
        .manual("urmath", "17.32")
        .doc("The square root of f. It is an error when f is negative.")
        .needs("f", Type.NUMBER)
        .returns(Type.NUMBER)
        .effect(Effect.COMPUTES)
        .does(MathBuiltins::sqrt);
  }

  private static double withinOne(Call<ControlBox> call) throws ScriptError {
    double f = call.number(0);
    if (f >= -1 && f <= 1) {
      return f;
    }
    throw call.refuse(0, text("minusOneToOne"));
  }

  private static int rounded(Call<ControlBox> call, double whole) throws ScriptError {
    int result = (int) whole;
    if (result != whole) {
      throw call.refuse(0, text("resultRange"));
    }
    return result;
  }

  private static Outcome log(Call<ControlBox> call) throws ScriptError {
    double base = call.number(0);
    double f = call.number(1);
    if (base < 0) {
      throw call.refuse(0, text("notNegative"));
    }
    if (base == 1) {
      throw call.refuse(0, text("notOne"));
    }
    if (f < 0) {
      throw call.refuse(1, text("notNegative"));
    }
    double quotient = Math.log(f) / Math.log(base);
    // the quotient of two rounded logarithms misses whole results by a bit: log(10, 1000)
    double whole = Math.rint(quotient);
    return call.answer(Math.pow(base, whole) == f ? whole : quotient);
  }

  private static Outcome pow(Call<ControlBox> call) throws ScriptError {
    double base = call.number(0);
    double exponent = call.number(1);
    if (base < 0 && exponent != Math.rint(exponent)) {
      throw call.refuse(1, text("wholeForNegativeBase"));
    }
    if (base == 0 && exponent < 0) {
      throw call.refuse(1, text("notNegativeForZeroBase"));
    }
    return call.answer(Math.pow(base, exponent));
  }

  private static Outcome sqrt(Call<ControlBox> call) throws ScriptError {
    double f = call.number(0);
    if (f < 0) {
      throw call.refuse(0, text("notNegative"));
    }
    return call.answer(Math.sqrt(f));
  }
}
