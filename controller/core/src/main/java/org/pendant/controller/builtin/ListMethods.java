package org.pendant.controller.builtin;

import static org.pendant.controller.builtin.BuiltinTexts.text;

import org.pendant.controller.box.ControlBox;
import org.pendant.language.signature.Type;
import org.pendant.script.function.Builtins;
import org.pendant.script.function.Call;
import org.pendant.script.function.Effect;
import org.pendant.script.function.Outcome;
import org.pendant.script.value.ListValue;
import org.pendant.script.value.NumberList;
import org.pendant.script.value.ObjectList;
import org.pendant.script.value.ScriptError;
import org.pendant.script.value.StructValue;
import org.pendant.script.value.Value;
import org.pendant.script.value.ValueKind;

/** The methods of lists (manual 4.3.1). They change the variable they are called on in place. */
final class ListMethods {
  private static final String MODULE = "core";
  private static final String SECTION = "4.3.1";

  /** What an element takes that is an object. */
  private static final int OBJECT_NS = 15;

  private ListMethods() {}

  static void declareIn(Builtins<ControlBox> builtins) {
    declareMeasures(builtins);
    declareChanges(builtins);
  }

  private static void declareMeasures(Builtins<ControlBox> builtins) {
    builtins
        .declareMethod(Type.LIST, "capacity")
        .manual(MODULE, SECTION)
        .doc("How many elements the list can hold; this never changes.")
        .returns(Type.INT)
        .effect(Effect.COMPUTES)
        .does(call -> call.answerInt(call.list(0).capacity()));
    builtins
        .declareMethod(Type.LIST, "excess_capacity")
        .manual(MODULE, SECTION)
        .doc("How many more elements fit.")
        .returns(Type.INT)
        .effect(Effect.COMPUTES)
        .does(call -> call.answerInt(call.list(0).capacity() - call.list(0).length()));
    builtins
        .declareMethod(Type.LIST, "length")
        .manual(MODULE, SECTION)
        .doc("The number of elements.")
        .returns(Type.INT)
        .effect(Effect.COMPUTES)
        .does(call -> call.answerInt(call.list(0).length()));
    builtins
        .declareMethod(Type.LIST, "slice")
        .manual(MODULE, SECTION)
        .doc("A new list of the elements from begin_index up to but without end_index.")
        .needs("begin_index", Type.INT)
        .needs("end_index", Type.INT)
        .returns(Type.LIST)
        .effect(Effect.COMPUTES)
        .does(ListMethods::slice);
    builtins
        .declareMethod(Type.LIST, "to_string")
        .manual(MODULE, SECTION)
        .doc("The list as text, shortened with ...] beyond 1023 characters.")
        .returns(Type.STRING)
        .effect(Effect.COMPUTES)
        .does(StringBuiltins::toStringMethod);
  }

  private static Outcome slice(Call<?> call) throws ScriptError {
    int begin = call.integer(1);
    int end = call.integer(2);
    call.charge(cost(call.list(0), Math.max(0, Math.min(end - begin, ListValue.MAX_CAPACITY))));
    return call.answer(call.list(0).slice(begin, end));
  }

  private static void declareChanges(Builtins<ControlBox> builtins) {
    builtins
        .declareMethod(Type.LIST, "append")
        .manual(MODULE, SECTION)
        .doc("Adds an element at the end. It is an error when the list is full.")
        .needs("element", Type.ANY)
        .effect(Effect.COMPUTES)
        .changesReceiver()
        .does(ListMethods::append);
    builtins
        .declareMethod(Type.LIST, "clear")
        .manual(MODULE, SECTION)
        .doc("Removes all elements.")
        .effect(Effect.COMPUTES)
        .changesReceiver()
        .does(ListMethods::clear);
    builtins
        .declareMethod(Type.LIST, "extend")
        .manual(MODULE, SECTION)
        .doc("Adds all elements of another list at the end. It is an error when they do not fit.")
        .needs("list", Type.LIST)
        .effect(Effect.COMPUTES)
        .changesReceiver()
        .does(ListMethods::extend);
    builtins
        .declareMethod(Type.LIST, "insert")
        .manual(MODULE, SECTION)
        .doc("Inserts an element before the one at index. It is an error when the list is full.")
        .needs("index", Type.INT)
        .needs("element", Type.ANY)
        .effect(Effect.COMPUTES)
        .changesReceiver()
        .does(ListMethods::insert);
    builtins
        .declareMethod(Type.LIST, "pop")
        .manual(MODULE, SECTION)
        .doc("Removes the last element and returns it.")
        .returns(Type.ANY)
        .effect(Effect.COMPUTES)
        .changesReceiver()
        .does(ListMethods::pop);
    builtins
        .declareMethod(Type.LIST, "remove")
        .manual(MODULE, SECTION)
        .doc("Removes the element at index; later ones move up.")
        .needs("index", Type.INT)
        .effect(Effect.COMPUTES)
        .changesReceiver()
        .does(ListMethods::remove);
  }

  /**
   * The list to change, whose elements are copied before if copies of it share them.
   *
   * @param elements how many elements the change goes through
   */
  private static ListValue changed(Call<?> call, int elements) throws ScriptError {
    ListValue list = call.list(0);
    call.charge((long) elements + (list.shared() ? list.capacity() : 0));
    return list;
  }

  /** What it takes to copy {@code count} elements, or one whose type is looked at as well. */
  private static long cost(ListValue list, int count) {
    return list instanceof ObjectList objects
        ? OBJECT_NS * (count + (objects.sample() instanceof StructValue s ? s.allMembers() : 0L))
        : count;
  }

  private static Outcome append(Call<?> call) throws ScriptError {
    ListValue list = changed(call, 1);
    call.charge(cost(list, 1));
    ValueKind kind = call.kind(1);
    if (list instanceof NumberList numbers && kind.isNumber()) {
      numbers.appendNumber(call.number(1), kind);
    } else {
      list.append(call.value(1).copy());
    }
    return call.answer();
  }

  private static Outcome clear(Call<?> call) throws ScriptError {
    call.charge(call.list(0) instanceof ObjectList list ? list.capacity() : 0);
    call.list(0).clear();
    return call.answer();
  }

  private static Outcome extend(Call<?> call) throws ScriptError {
    ListValue source = call.list(1);
    call.charge(cost(source, source.length()));
    changed(call, source.length()).extend(source);
    return call.answer();
  }

  private static Outcome insert(Call<?> call) throws ScriptError {
    call.charge(cost(call.list(0), 1));
    changed(call, call.list(0).length()).insert(call.integer(1), call.value(2).copy());
    return call.answer();
  }

  private static Outcome pop(Call<?> call) throws ScriptError {
    ListValue list = changed(call, 1);
    if (list.length() == 0) {
      throw call.failure("index-out-of-range", text("emptyList"));
    }
    // the last element may be part of a copy of the list as well
    Value last = list.get(list.length() - 1).copy();
    list.remove(list.length() - 1);
    return call.answer(last);
  }

  private static Outcome remove(Call<?> call) throws ScriptError {
    changed(call, call.list(0).length()).remove(call.integer(1));
    return call.answer();
  }
}
