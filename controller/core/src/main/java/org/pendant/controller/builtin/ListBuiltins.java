package org.pendant.controller.builtin;

import static org.pendant.controller.builtin.BuiltinTexts.text;

import java.util.Arrays;
import org.pendant.controller.box.ControlBox;
import org.pendant.language.signature.Type;
import org.pendant.language.signature.Unit;
import org.pendant.script.function.Builtins;
import org.pendant.script.function.Call;
import org.pendant.script.function.Effect;
import org.pendant.script.function.Outcome;
import org.pendant.script.value.ListValue;
import org.pendant.script.value.MatrixValue;
import org.pendant.script.value.NumberList;
import org.pendant.script.value.ObjectList;
import org.pendant.script.value.ScriptError;
import org.pendant.script.value.StringValue;
import org.pendant.script.value.StructValue;
import org.pendant.script.value.Value;
import org.pendant.script.value.ValueKind;

/** Functions that make and measure lists (manual 17); their methods are {@link ListMethods}. */
final class ListBuiltins {
  private static final int OBJECT_NS = 4;

  private ListBuiltins() {}

  static void declareIn(Builtins<ControlBox> builtins) {
    builtins
        .declare("binary_list_to_integer")
        .manual("urmath", "17.5")
        .doc(
            "The int whose bits a list of bools holds, the lowest first. Bools after the first 32"
                + " do not count, an empty list is 0.")
        .needs("l", Type.LIST)
        .returns(Type.INT)
        .effect(Effect.COMPUTES)
        .does(ListBuiltins::integerOfBits);
    builtins
        .declare("get_list_length")
        .manual("urmath", "17.11")
        .doc("The number of elements of a list.")
        .needs("v", Type.LIST)
        .returns(Type.INT)
        .effect(Effect.COMPUTES)
        .does(call -> call.answerInt(call.list(0).length()));
    builtins
        .declare("integer_to_binary_list")
        .manual("urmath", "17.12")
        .doc("The 32 bits of an int as a list of bools, the lowest first.")
        .needs("x", Type.INT)
        .returns(Type.LIST)
        .effect(Effect.COMPUTES)
        .does(ListBuiltins::bitsOfInteger);
    builtins
        .declare("length")
        .manual("urmath", "17.15")
        .doc("The number of elements of a list, bytes of a string or members of a struct.")
        .needs("v", Type.ANY)
        .returns(Type.INT)
        .effect(Effect.COMPUTES)
        .does(ListBuiltins::length);
    builtins
        .declare("make_list")
        .manual("urmath", "17.10")
        .doc(
            "A new list of equal elements, with room for as many as capacity says. The initial"
                + " value fixes the type of the elements, also of a list of length 0.")
        .needs("length", Type.INT)
        .needs("initial_value", Type.ANY)
        .mayTake("capacity", Type.INT, Unit.NONE, "length")
        .returns(Type.LIST)
        .effect(Effect.COMPUTES)
        .does(ListBuiltins::makeList);
    builtins
        .declare("size")
        .manual("urmath", "17.31")
        .doc(
            "The number of elements of a list or bytes of a string; of a matrix the numbers of rows"
                + " and columns, as a list of two.")
        .needs("v", Type.ANY)
        .returns(Type.ANY)
        .effect(Effect.COMPUTES)
        .does(ListBuiltins::size);
  }

  private static Outcome integerOfBits(Call<?> call) throws ScriptError {
    ListValue list = call.list(0);
    int bits = 0;
    if (list instanceof NumberList bools
        && (bools.elementKind() == ValueKind.BOOL || list.length() == 0)) {
      for (int i = 0; i < Math.min(Integer.SIZE, bools.length()); i++) {
        bits |= (int) bools.numberAt(i) << i;
      }
      return call.answerInt(bits);
    }
    throw call.wrongKind(0, text("listOfBool"));
  }

  private static Outcome bitsOfInteger(Call<?> call) throws ScriptError {
    int x = call.integer(0);
    boolean[] bits = new boolean[Integer.SIZE];
    for (int i = 0; i < bits.length; i++) {
      bits[i] = (x >>> i & 1) != 0;
    }
    return call.answer(NumberList.ofBools(bits));
  }

  private static Outcome length(Call<?> call) throws ScriptError {
    return switch (call.value(0)) {
      case ListValue list -> call.answerInt(list.length());
      case StringValue text -> call.answerInt(text.length());
      case StructValue struct -> call.answerInt(struct.length());
      default -> throw call.wrongKind(0, text("listStringOrStruct"));
    };
  }

  private static Outcome size(Call<?> call) throws ScriptError {
    return switch (call.value(0)) {
      case ListValue list -> call.answerInt(list.length());
      case StringValue text -> call.answerInt(text.length());
      case MatrixValue matrix -> call.answer(MatrixBuiltins.shape(matrix));
      default -> throw call.wrongKind(0, text("listStringOrMatrix"));
    };
  }

  private static Outcome makeList(Call<?> call) throws ScriptError {
    int length = call.integer(0, 0, ListValue.MAX_CAPACITY);
    int capacity = call.given(2) ? call.integer(2, length, ListValue.MAX_CAPACITY) : length;
    ValueKind kind = call.kind(1);
    return switch (kind) {
      case BOOL, INT, FLOAT -> {
        call.charge(capacity);
        double[] elements = new double[capacity];
        double initial = kind == ValueKind.BOOL ? (call.bool(1) ? 1 : 0) : call.number(1);
        Arrays.fill(elements, 0, length, initial);
        yield call.answer(NumberList.owning(elements, length, kind));
      }
      case STRING, POSE, STRUCT, HANDLE -> {
        Value[] elements = new Value[capacity];
        // code that changes one of them takes a copy of it
        Arrays.fill(elements, 0, length, call.value(1).copy());
        call.charge(capacity + OBJECT_NS * (long) length);
        yield call.answer(ObjectList.owning(elements, length, call.value(1).copy()));
      }
      case NONE, LIST, MATRIX -> throw call.wrongKind(1, text("kindsOfElements"));
    };
  }
}
