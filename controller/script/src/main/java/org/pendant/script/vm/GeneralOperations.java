package org.pendant.script.vm;

import static org.pendant.script.vm.MachineTexts.text;

import java.util.Optional;
import org.pendant.language.syntax.Expression.BinaryOperator;
import org.pendant.models.pose.Pose;
import org.pendant.script.function.Builtin;
import org.pendant.script.function.Work;
import org.pendant.script.value.BoolValue;
import org.pendant.script.value.HandleValue;
import org.pendant.script.value.LongOperation;
import org.pendant.script.value.MatrixValue;
import org.pendant.script.value.NoneValue;
import org.pendant.script.value.ObjectList;
import org.pendant.script.value.Operators;
import org.pendant.script.value.PoseValue;
import org.pendant.script.value.Registers;
import org.pendant.script.value.ScriptError;
import org.pendant.script.value.StringValue;
import org.pendant.script.value.StructValue;
import org.pendant.script.value.Value;
import org.pendant.script.value.ValueKind;
import org.pendant.script.value.ValueText;
import org.pendant.script.vm.Processor.Stop;

/**
 * General operations: what instructions do when their operands are not plain numbers, and every
 * refusal: values are boxed here and handed to {@link Operators}.
 */
final class GeneralOperations {
  private static final Value ZERO = Value.of(0);

  /** Characters of a value that a message shows. */
  private static final int MAX_SHOWN = 80;

  /** Above this a comparison is made piece by piece. */
  private static final int LONG_COMPARISON_NS = 200_000;

  private final ProgramRun run;
  private final Registers registers;
  private final Work work;

  GeneralOperations(ProgramRun run) {
    this.run = run;
    this.registers = run.registers();
    work = run.work();
  }

  ScriptError unassigned(ScriptFunction function, int operand) {
    int index = Instruction.index(operand);
    String name =
        Instruction.isLocal(operand)
            ? index < function.variableCount() ? function.variables().get(index) : ""
            : run.staticName(index);
    return new ScriptError(
        "unassigned-variable", name.isEmpty() ? text("valueMissing") : text("noValueYet", name));
  }

  ScriptError notOrdered(ScriptFunction function, int x, int y) throws ScriptError {
    assigned(function, x);
    assigned(function, y);
    return new ScriptError("wrong-type", text("notOrdered", describe(x), describe(y)));
  }

  /**
   * Sees to it that the number in {@code slot} is the truth of its value: it is for bools and
   * numbers, and a string, which has no number, is true unless it is empty (manual 18.61).
   */
  void truth(ScriptFunction function, int slot) throws ScriptError {
    if (registers.tags()[slot] <= Registers.BOOL) {
      return;
    }
    assigned(function, slot);
    if (!(registers.value(slot) instanceof StringValue text)) {
      throw new ScriptError("wrong-type", text("notBool", describe(slot)));
    }
    registers.numbers()[slot] = text.length() == 0 ? 0 : 1;
  }

  private String describe(int slot) {
    return registers.kind(slot).text()
        + " "
        + ValueText.shortened(registers.value(slot), MAX_SHOWN);
  }

  /** Refuses a slot without a value; the name is not known here any more, only the instruction. */
  private void assigned(ScriptFunction function, int slot) throws ScriptError {
    if (!registers.assigned(slot)) {
      throw new ScriptError("unassigned-variable", text("variableWithoutValue", function.name()));
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
    if (isTemporary(function, operand)) {
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
    Value current = registers.value(slot);
    work.charge(Cost.assign(current, value));
    try {
      registers.set(slot, Operators.assign(current, value));
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
    assignValue(function, target, slot, copy ? copied(value) : value);
  }

  /** A copy of {@code value} that a variable or container will own. */
  Value copied(Value value) {
    work.charge(Cost.GENERAL_NS);
    work.take(value.sizeBytes());
    return value.copy();
  }

  Stop add(ScriptThread thread, long w, int base) throws ScriptError {
    return join(w, base) ? Stop.GOES_ON : arithmetic(BinaryOperator.ADD, thread, w, base);
  }

  /** Adds two strings where another string was; whether that is what had to be done. */
  boolean join(long w, int base) throws ScriptError {
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
      objects[target] = joined(head, tail);
      return true;
    }
    return false;
  }

  private StringValue joined(StringValue head, StringValue tail) throws ScriptError {
    StringValue joined = Operators.concatenated(head, tail);
    int copied = joined.copiedFor(head);
    work.charge(Cost.GENERAL_NS + (long) Cost.bytes(copied));
    work.take(copied);
    return joined;
  }

  /** Any operator; {@link Stop#EXHAUSTED} if it is not done with. */
  Stop arithmetic(BinaryOperator operator, ScriptThread thread, long w, int base)
      throws ScriptError {
    ScriptFunction function = thread.functions[thread.depth - 1];
    Optional<Value> result;
    if (thread.operation.isPresent()) {
      result = advance(thread, thread.operation.get());
    } else {
      Value left = read(function, Instruction.b(w), base);
      Value right = read(function, Instruction.c(w), base);
      result = combine(operator, thread, left, right);
    }
    return finish(function, w, base, result);
  }

  private Stop finish(ScriptFunction function, long w, int base, Optional<Value> result)
      throws ScriptError {
    if (result.isEmpty()) {
      return Stop.EXHAUSTED;
    }
    store(function, Instruction.a(w), base, result.get());
    return Stop.GOES_ON;
  }

  private Optional<Value> combine(
      BinaryOperator operator, ScriptThread thread, Value left, Value right) throws ScriptError {
    if (left instanceof StringValue head
        && right instanceof StringValue tail
        && operator == BinaryOperator.ADD) {
      return Optional.of(joined(head, tail));
    }
    if (Operators.elementwise(operator, left, right)) {
      work.charge(Cost.GENERAL_NS);
      return advance(thread, Operators.begin(operator, left, right));
    }
    return Optional.of(Operators.binary(operator, left, right));
  }

  /** Computes a piece; the result if that was the last. */
  private Optional<Value> advance(ScriptThread thread, LongOperation operation) throws ScriptError {
    work.charge(Cost.elements(operation.advance()));
    if (operation.done()) {
      thread.operation = Optional.empty();
      Value result = operation.result();
      work.take(result.sizeBytes());
      return Optional.of(result);
    }
    suspend(thread, operation);
    return Optional.empty();
  }

  private void suspend(ScriptThread thread, LongOperation operation) {
    if (thread.operation.isEmpty()) {
      operation.keep();
      thread.operation = Optional.of(operation);
    }
    work.take(operation.sizeBytes());
  }

  /** Continues with an operation of a built-in while the slice lasts; whether it is done. */
  boolean finish(ScriptThread thread, LongOperation operation) throws ScriptError {
    thread.budget -= work.settleNs();
    while (!operation.done() && thread.budget >= 0) {
      thread.budget -= operation.advance();
    }
    if (operation.done()) {
      thread.operation = Optional.empty();
      return true;
    }
    suspend(thread, operation);
    return false;
  }

  Stop negate(ScriptThread thread, long w, int base) throws ScriptError {
    ScriptFunction function = thread.functions[thread.depth - 1];
    int source = Instruction.slot(Instruction.b(w), base);
    int slot = Instruction.slot(Instruction.a(w), base);
    if (registers.tags()[source] == Registers.FLOAT && registers.tags()[slot] <= Registers.FLOAT) {
      registers.setFloat(slot, -registers.numbers()[source]);
      return Stop.GOES_ON;
    }
    if (thread.operation.isPresent()) {
      return finish(function, w, base, advance(thread, thread.operation.get()));
    }
    Value value = read(function, Instruction.b(w), base);
    if (Operators.elementwise(BinaryOperator.SUBTRACT, ZERO, value)) {
      LongOperation negation = Operators.begin(BinaryOperator.SUBTRACT, ZERO, value);
      return finish(function, w, base, advance(thread, negation));
    }
    store(function, Instruction.a(w), base, Operators.negate(value));
    return Stop.GOES_ON;
  }

  /** Whether two slots are equal, 1 or 0; {@link SlowPath#STOPPED} if that is not known yet. */
  int equal(ScriptThread thread, int x, int y) throws ScriptError {
    if (thread.operation.isPresent()) {
      return truth(advance(thread, thread.operation.get()));
    }
    if (!registers.assigned(x) || !registers.assigned(y)) {
      throw new ScriptError("unassigned-variable", text("comparedWithoutValue"));
    }
    Value left = registers.value(x);
    Value right = registers.value(y);
    int cost = Cost.comparison(left, right);
    if (cost > LONG_COMPARISON_NS) {
      return truth(advance(thread, Operators.beginEqual(left, right)));
    }
    work.charge(cost);
    return Operators.equal(left, right) ? 1 : 0;
  }

  private static int truth(Optional<Value> result) {
    return result
        .map(value -> value instanceof BoolValue bool && bool.value() ? 1 : 0)
        .orElse(SlowPath.STOPPED);
  }

  void getIndex(ScriptFunction function, long w, int base) throws ScriptError {
    if (getComponent(function, w, base)) {
      return;
    }
    Value receiver = read(function, Instruction.b(w), base);
    Value index = read(function, Instruction.c(w), base);
    if (receiver instanceof MatrixValue matrix) {
      work.charge(matrix.columns());
    }
    store(function, Instruction.a(w), base, Operators.index(receiver, index));
  }

  /** A component of a pose, which programs read often; whether that is what had to be done. */
  private boolean getComponent(ScriptFunction function, long w, int base) {
    byte[] tags = registers.tags();
    int target = Instruction.slot(Instruction.a(w), base);
    int slot = Instruction.slot(Instruction.b(w), base);
    int index = Instruction.slot(Instruction.c(w), base);
    if (tags[slot] == Registers.OBJECT
        && isComponent(index)
        && registers.objects()[slot] instanceof PoseValue pose
        && (isTemporary(function, Instruction.a(w))
            || (tags[target] & Processor.NOT_FOR_NUMBER) == 0)) {
      registers.setFloat(target, pose.pose().get((int) registers.numbers()[index]));
      return true;
    }
    return false;
  }

  /** Whether a slot holds the index of a component of a pose. */
  private boolean isComponent(int slot) {
    double index = registers.numbers()[slot];
    return registers.tags()[slot] == Registers.INT && index >= 0 && index < Pose.SIZE;
  }

  private static boolean isTemporary(ScriptFunction function, int operand) {
    return Instruction.isLocal(operand) && Instruction.index(operand) >= function.variableCount();
  }

  /** Opens an element of a container for a change; the target is always a temporary. */
  void openIndex(ScriptFunction function, long w, int base) throws ScriptError {
    Value receiver = read(function, Instruction.b(w), base);
    Value index = read(function, Instruction.c(w), base);
    chargeChange(receiver);
    registers.set(Instruction.slot(Instruction.a(w), base), Operators.open(receiver, index));
  }

  /** Opens a member of a struct for a change; the target is always a temporary. */
  void openMember(ScriptFunction function, long w, int base) throws ScriptError {
    Value receiver = read(function, Instruction.b(w), base);
    String name = run.name(Instruction.index(Instruction.c(w)));
    chargeChange(receiver);
    registers.set(
        Instruction.slot(Instruction.a(w), base),
        receiver instanceof HandleValue handle
            ? handle.member(name)
            : Operators.openMember(receiver, name));
  }

  private void chargeChange(Value container) {
    int copied = Cost.change(container);
    work.charge(Cost.GENERAL_NS + (long) copied);
    work.take(copied);
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
    if (setComponent(w, base)) {
      return;
    }
    Value receiver = read(function, Instruction.a(w), base);
    Value index = read(function, Instruction.b(w), base);
    Value element = read(function, Instruction.c(w), base);
    chargeChange(receiver);
    work.charge(Cost.type(element));
    registers.set(
        Instruction.slot(Instruction.a(w), base), Operators.setIndex(receiver, index, element));
  }

  /** A component of a pose becomes a number; whether that is what had to be done. */
  private boolean setComponent(long w, int base) {
    int slot = Instruction.slot(Instruction.a(w), base);
    int index = Instruction.slot(Instruction.b(w), base);
    int source = Instruction.slot(Instruction.c(w), base);
    if (registers.tags()[slot] == Registers.OBJECT
        && isComponent(index)
        && registers.tags()[source] <= Registers.FLOAT
        && registers.objects()[slot] instanceof PoseValue pose) {
      work.charge(Cost.GENERAL_NS);
      double[] numbers = registers.numbers();
      registers.objects()[slot] =
          new PoseValue(pose.pose().with((int) numbers[index], numbers[source]));
      return true;
    }
    return false;
  }

  void setIndex2(ScriptFunction function, long w, int base) throws ScriptError {
    int slot = Instruction.slot(Instruction.a(w), base);
    int row = Instruction.slot(Instruction.b(w), base);
    int source = Instruction.slot(Instruction.c(w), base);
    if (areInts(row)
        && registers.tags()[source] <= Registers.FLOAT
        && registers.tags()[slot] == Registers.OBJECT
        && registers.objects()[slot] instanceof MatrixValue matrix) {
      if (matrix.shared()) {
        chargeChange(matrix);
      }
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
    chargeChange(receiver);
    work.charge(Cost.type(value));
    registers.set(
        Instruction.slot(Instruction.a(w), base), Operators.setMember(receiver, name, value));
  }

  Stop list(ScriptThread thread, long w, int base) throws ScriptError {
    int target = base + Instruction.index(Instruction.a(w));
    int first = base + Instruction.index(Instruction.c(w));
    int count = Instruction.index(Instruction.b(w));
    Value list;
    if (count > 0 && registers.kind(first) == ValueKind.LIST) {
      Optional<Value> matrix =
          advance(
              thread,
              thread.operation.isPresent()
                  ? thread.operation.get()
                  : Operators.beginMatrix(values(first, count)));
      if (matrix.isEmpty()) {
        return Stop.EXHAUSTED;
      }
      list = matrix.get();
    } else {
      list = Operators.listLiteral(registers, first, count);
      work.take(list.sizeBytes());
      if (list instanceof ObjectList objects) {
        work.charge(count * (long) Cost.type(objects.sample()));
      }
    }
    work.charge(count * (long) Cost.GENERAL_NS);
    registers.set(target, list);
    return Stop.GOES_ON;
  }

  private Value[] values(int first, int count) {
    Value[] values = new Value[count];
    for (int i = 0; i < count; i++) {
      values[i] = registers.value(first + i);
    }
    return values;
  }

  void pose(long w, int base) throws ScriptError {
    int first = base + Instruction.index(Instruction.c(w));
    double[] numbers = registers.numbers();
    for (int i = first; i < first + 6; i++) {
      if (registers.tags()[i] > Registers.FLOAT) {
        throw new ScriptError("wrong-type", text("poseElement", i - first, describe(i)));
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
        throw new ScriptError("wrong-type", text("memberWithoutValue", names.get(i)));
      }
    }
    StructValue struct = StructValue.owning(names, members).checked();
    work.charge((long) members.length * Cost.GENERAL_NS);
    work.take(struct.sizeBytes());
    registers.set(base + Instruction.index(Instruction.a(w)), struct);
  }

  /** The built-in method that method number {@code name} is for the receiver in {@code slot}. */
  Builtin<?> method(int name, int slot) throws ScriptError {
    if (registers.kind(slot) == ValueKind.HANDLE
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
          registers.assigned(slot)
              ? text("noThreadHandle", statement, describe(slot))
              : text("variableNoThreadHandle", statement));
    }
    return (int) registers.numbers()[slot];
  }

  /** Makes room for a call of {@code callee} with its slots from {@code base}. */
  void makeRoom(ScriptThread thread, ScriptFunction callee, int base) throws ScriptError {
    if (thread.depth >= ScriptThread.MAX_DEPTH) {
      throw new ScriptError(
          "too-deep", text("callsTooDeep", ScriptThread.MAX_DEPTH, callee.name()));
    }
    run.segments().checkEnlarge(thread, base + callee.slotCount());
    work.charge(run.segments().enlarge(thread, base + callee.slotCount()));
  }
}
