package org.pendant.controller.machine;

import org.pendant.controller.call.Builtin;
import org.pendant.controller.value.HandleValue;
import org.pendant.controller.value.Kind;
import org.pendant.controller.value.MatrixValue;
import org.pendant.controller.value.NoneValue;
import org.pendant.controller.value.Operators;
import org.pendant.controller.value.PoseValue;
import org.pendant.controller.value.Registers;
import org.pendant.controller.value.ScriptError;
import org.pendant.controller.value.StringValue;
import org.pendant.controller.value.StructValue;
import org.pendant.controller.value.Value;
import org.pendant.language.syntax.Expression.BinaryOperator;
import org.pendant.models.pose.Pose;

/**
 * What instructions do when their operands are not plain numbers, and every refusal: values are
 * boxed here and handed to {@link Operators}.
 */
final class GeneralOperations {
  private final ProgramRun run;
  private final Registers registers;

  GeneralOperations(ProgramRun run) {
    this.run = run;
    this.registers = run.registers();
  }

  ScriptError unassigned(ScriptFunction function, int operand) {
    int index = Instruction.index(operand);
    String name =
        Instruction.isLocal(operand)
            ? index < function.variableCount() ? function.variables().get(index) : ""
            : run.staticName(index);
    return new ScriptError(
        "unassigned-variable", name.isEmpty() ? "a value is missing" : name + " has no value yet");
  }

  ScriptError notOrdered(ScriptFunction function, int x, int y) throws ScriptError {
    assigned(function, x);
    assigned(function, y);
    return new ScriptError(
        "wrong-type",
        "cannot order a " + describe(x) + " and a " + describe(y) + ", only numbers have an order");
  }

  ScriptError notTruth(ScriptFunction function, int slot) throws ScriptError {
    assigned(function, slot);
    return new ScriptError("wrong-type", describe(slot) + " is not a bool");
  }

  private String describe(int slot) {
    return registers.kind(slot).text() + " " + registers.value(slot).text();
  }

  /** Refuses a slot without a value; the name is not known here any more, only the instruction. */
  private void assigned(ScriptFunction function, int slot) throws ScriptError {
    if (!registers.assigned(slot)) {
      throw new ScriptError(
          "unassigned-variable", "a variable in " + function.name() + " has no value yet");
    }
  }

  private Value read(ScriptFunction function, int operand, int base) throws ScriptError {
    int slot = Instruction.slot(operand, base);
    if (!registers.assigned(slot)) {
      throw unassigned(function, operand);
    }
    return registers.value(slot);
  }

  /** Stores a result: into a temporary as it is, into a variable with its type kept. */
  private void store(ScriptFunction function, int operand, int base, Value value)
      throws ScriptError {
    int slot = Instruction.slot(operand, base);
    if (Instruction.isLocal(operand) && Instruction.index(operand) >= function.variableCount()) {
      registers.set(slot, value);
    } else {
      assignValue(function, operand, slot, value);
    }
  }

  private void assignValue(ScriptFunction function, int operand, int slot, Value value)
      throws ScriptError {
    if (!registers.assigned(slot)) {
      registers.set(slot, value);
      return;
    }
    try {
      registers.set(slot, Operators.assign(registers.value(slot), value));
    } catch (ScriptError e) {
      int index = Instruction.index(operand);
      String name =
          Instruction.isLocal(operand) ? function.variables().get(index) : run.staticName(index);
      throw new ScriptError(e.code(), name + " " + e.getMessage());
    }
  }

  void assign(ScriptFunction function, int target, int slot, int operand, int source, boolean copy)
      throws ScriptError {
    if (!registers.assigned(source)) {
      throw unassigned(function, operand);
    }
    if (source == slot) {
      return;
    }
    byte tag = registers.tags()[source];
    if (tag != Registers.OBJECT && (!registers.assigned(slot) || registers.tags()[slot] == tag)) {
      registers.numbers()[slot] = registers.numbers()[source];
      registers.tags()[slot] = tag;
      return;
    }
    Value value = registers.value(source);
    assignValue(function, target, slot, copy ? value.copy() : value);
  }

  /** Addition; strings, which programs build piece by piece, without a detour. */
  void add(ScriptFunction function, long w, int base) throws ScriptError {
    Value[] objects = registers.objects();
    byte[] tags = registers.tags();
    int x = Instruction.slot(Instruction.b(w), base);
    int y = Instruction.slot(Instruction.c(w), base);
    int target = Instruction.slot(Instruction.a(w), base);
    if (tags[x] == Registers.OBJECT
        && tags[y] == Registers.OBJECT
        && tags[target] == Registers.OBJECT
        && objects[x] instanceof StringValue head
        && objects[y] instanceof StringValue tail
        && objects[target] instanceof StringValue) {
      objects[target] = Operators.concatenated(head, tail);
    } else {
      arithmetic(BinaryOperator.ADD, function, w, base);
    }
  }

  void arithmetic(BinaryOperator operator, ScriptFunction function, long w, int base)
      throws ScriptError {
    Value left = read(function, Instruction.b(w), base);
    Value right = read(function, Instruction.c(w), base);
    store(function, Instruction.a(w), base, Operators.binary(operator, left, right));
  }

  void negate(ScriptFunction function, long w, int base) throws ScriptError {
    int source = Instruction.slot(Instruction.b(w), base);
    int slot = Instruction.slot(Instruction.a(w), base);
    if (registers.tags()[source] == Registers.FLOAT && registers.tags()[slot] <= Registers.FLOAT) {
      registers.setFloat(slot, -registers.numbers()[source]);
    } else {
      Value value = read(function, Instruction.b(w), base);
      store(function, Instruction.a(w), base, Operators.negate(value));
    }
  }

  boolean equal(int x, int y) throws ScriptError {
    if (!registers.assigned(x) || !registers.assigned(y)) {
      throw new ScriptError("unassigned-variable", "a variable compared here has no value yet");
    }
    return Operators.equal(registers.value(x), registers.value(y));
  }

  void getIndex(ScriptFunction function, long w, int base) throws ScriptError {
    Value receiver = read(function, Instruction.b(w), base);
    Value index = read(function, Instruction.c(w), base);
    store(function, Instruction.a(w), base, Operators.index(receiver, index));
  }

  /** The target is always a temporary, see {@link ExpressionCompiler}. */
  void getIndex2(ScriptFunction function, long w, int base) throws ScriptError {
    int row = Instruction.slot(Instruction.c(w), base);
    int slot = Instruction.slot(Instruction.b(w), base);
    if (areInts(row)
        && registers.tags()[slot] == Registers.OBJECT
        && registers.objects()[slot] instanceof MatrixValue matrix) {
      double number =
          matrix.get((int) registers.numbers()[row], (int) registers.numbers()[row + 1]);
      int target = Instruction.slot(Instruction.a(w), base);
      registers.numbers()[target] = number;
      registers.tags()[target] = matrix.integers() ? Registers.INT : Registers.FLOAT;
    } else {
      Value receiver = read(function, Instruction.b(w), base);
      Value first = read(function, Instruction.c(w), base);
      Value second = read(function, Instruction.c(w) + 1, base);
      store(function, Instruction.a(w), base, Operators.index(receiver, first, second));
    }
  }

  /** Whether a slot and the next one hold ints. */
  private boolean areInts(int slot) {
    byte[] tags = registers.tags();
    return (tags[slot] | tags[slot + 1]) == Registers.INT;
  }

  void setIndex(ScriptFunction function, long w, int base) throws ScriptError {
    Value receiver = read(function, Instruction.a(w), base);
    Value index = read(function, Instruction.b(w), base);
    Value element = read(function, Instruction.c(w), base);
    registers.set(
        Instruction.slot(Instruction.a(w), base), Operators.setIndex(receiver, index, element));
  }

  void setIndex2(ScriptFunction function, long w, int base) throws ScriptError {
    int slot = Instruction.slot(Instruction.a(w), base);
    int row = Instruction.slot(Instruction.b(w), base);
    int source = Instruction.slot(Instruction.c(w), base);
    if (areInts(row)
        && registers.tags()[source] <= Registers.FLOAT
        && registers.tags()[slot] == Registers.OBJECT
        && registers.objects()[slot] instanceof MatrixValue matrix) {
      matrix.set(
          (int) registers.numbers()[row],
          (int) registers.numbers()[row + 1],
          registers.numbers()[source],
          registers.tags()[source] == Registers.INT);
    } else {
      Value receiver = read(function, Instruction.a(w), base);
      Value first = read(function, Instruction.b(w), base);
      Value second = read(function, Instruction.b(w) + 1, base);
      Value element = read(function, Instruction.c(w), base);
      registers.set(slot, Operators.setIndex(receiver, first, second, element));
    }
  }

  void getMember(ScriptFunction function, long w, int base) throws ScriptError {
    Value receiver = read(function, Instruction.b(w), base);
    String name = run.name(Instruction.index(Instruction.c(w)));
    store(
        function,
        Instruction.a(w),
        base,
        receiver instanceof HandleValue handle
            ? handle.member(name)
            : Operators.member(receiver, name));
  }

  void setMember(ScriptFunction function, long w, int base) throws ScriptError {
    Value receiver = read(function, Instruction.a(w), base);
    String name = run.name(Instruction.index(Instruction.b(w)));
    Value value = read(function, Instruction.c(w), base);
    registers.set(
        Instruction.slot(Instruction.a(w), base), Operators.setMember(receiver, name, value));
  }

  void list(long w, int base) throws ScriptError {
    Value[] elements = new Value[Instruction.index(Instruction.b(w))];
    int first = base + Instruction.index(Instruction.c(w));
    for (int i = 0; i < elements.length; i++) {
      elements[i] = registers.value(first + i);
    }
    registers.set(base + Instruction.index(Instruction.a(w)), Operators.listLiteral(elements));
  }

  void pose(long w, int base) throws ScriptError {
    int first = base + Instruction.index(Instruction.c(w));
    double[] numbers = registers.numbers();
    for (int i = first; i < first + 6; i++) {
      if (registers.tags()[i] > Registers.FLOAT) {
        throw new ScriptError(
            "wrong-type",
            "pose element " + (i - first) + " is a " + describe(i) + ", must be a number");
      }
    }
    Pose pose =
        new Pose(
            numbers[first],
            numbers[first + 1],
            numbers[first + 2],
            numbers[first + 3],
            numbers[first + 4],
            numbers[first + 5]);
    registers.set(base + Instruction.index(Instruction.a(w)), new PoseValue(pose));
  }

  void struct(long w, int base) throws ScriptError {
    var names = run.names(Instruction.index(Instruction.b(w)));
    Value[] members = new Value[names.size()];
    int first = base + Instruction.index(Instruction.c(w));
    for (int i = 0; i < members.length; i++) {
      members[i] = registers.value(first + i);
      if (members[i] == NoneValue.NONE) {
        throw new ScriptError("wrong-type", "struct: member " + names.get(i) + " has no value");
      }
    }
    registers.set(base + Instruction.index(Instruction.a(w)), StructValue.owning(names, members));
  }

  /** The built-in method that method number {@code name} is for the receiver in {@code slot}. */
  Builtin method(int name, int slot) throws ScriptError {
    if (registers.kind(slot) == Kind.HANDLE
        && registers.objects()[slot] instanceof HandleValue handle) {
      return run.methods().find(run.name(name), handle.type());
    }
    return run.methods().find(run.name(name), registers.kind(slot));
  }

  /** The thread number in {@code slot}. */
  int handle(String statement, int slot) throws ScriptError {
    if (registers.tags()[slot] != Registers.INT) {
      throw new ScriptError(
          "wrong-type",
          statement
              + (registers.assigned(slot) ? ": " + describe(slot) : ": the variable")
              + " is not a thread handle");
    }
    return (int) registers.numbers()[slot];
  }

  /** Makes room for a call of {@code callee} with its slots from {@code base}. */
  void makeRoom(ScriptThread thread, ScriptFunction callee, int base) throws ScriptError {
    if (thread.depth >= ScriptThread.MAX_DEPTH) {
      throw new ScriptError(
          "too-deep",
          "functions call each other more than "
              + ScriptThread.MAX_DEPTH
              + " deep, the innermost is "
              + callee.name());
    }
    run.segments().enlarge(thread, base + callee.slotCount());
  }
}
