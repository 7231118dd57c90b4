package org.pendant.script.function;

import java.util.Locale;
import java.util.Optional;
import org.pendant.models.arm.Joints;
import org.pendant.models.pose.Pose;
import org.pendant.script.value.ListValue;
import org.pendant.script.value.LongOperation;
import org.pendant.script.value.MatrixValue;
import org.pendant.script.value.NumberList;
import org.pendant.script.value.PoseValue;
import org.pendant.script.value.Registers;
import org.pendant.script.value.ScriptError;
import org.pendant.script.value.StringValue;
import org.pendant.script.value.StructValue;
import org.pendant.script.value.Value;
import org.pendant.script.value.ValueKind;
import org.pendant.script.value.ValueText;

/**
 * Call of a built-in function: its arguments, one a parameter with defaults filled in, and the
 * place for its answer. A machine reuses one object for all calls: never keep it, take what a wait
 * needs out of it first.
 *
 * <p>Arguments are counted from 0; for a method, argument 0 is the receiver. The typed accessors
 * throw a {@link ScriptError} that names function, parameter and value when the argument is of
 * another kind.
 *
 * @param <H> what programs run on
 */
public final class Call<H extends Host> {
  /** Characters of a value that a message shows. */
  private static final int MAX_SHOWN = 80;

  /** Most bytes of a text that is made of values for the log or the outside. */
  public static final int MAX_TEXT = 4 << 20;

  /** Bytes that are copied in a nanosecond, roughly. */
  private static final int BYTES_A_NS = 8;

  private final H host;
  private final ProgramControl program;
  private final Registers registers;
  private final Work work;
  private Builtin<?> builtin;
  private int firstArgument;
  private int resultSlot;
  private Optional<Value> prepared = Optional.empty();

  /** For the machine: calls whose values stand in {@code registers}. */
  public Call(H host, ProgramControl program, Registers registers, Work work) {
    this.host = host;
    this.program = program;
    this.registers = registers;
    this.work = work;
  }

  /** For the machine: calls {@code builtin} with the arguments from slot {@code firstArgument}. */
  public Outcome run(Builtin<?> builtin, int firstArgument, int resultSlot) throws ScriptError {
    this.builtin = builtin;
    this.firstArgument = firstArgument;
    this.resultSlot = resultSlot;
    work.charge(builtin.costNs());
    return code(builtin).run(this);
  }

  @SuppressWarnings("unchecked") // a machine is given functions and a host that belong together
  private BuiltinCode<H> code(Builtin<?> called) {
    return (BuiltinCode<H>) called.code();
  }

  /** For the machine: continues with a call whose {@link Outcome.Begun operation} is done. */
  public Outcome resume(Builtin<?> builtin, int firstArgument, int resultSlot, Value result)
      throws ScriptError {
    prepared = Optional.of(result);
    try {
      return run(builtin, firstArgument, resultSlot);
    } finally {
      prepared = Optional.empty();
    }
  }

  /** What is done with a text. */
  public interface TextUse {
    Outcome use(String bytes) throws ScriptError;
  }

  /**
   * Answers what {@code use} does with the texts of arguments, one after the other. Long ones take
   * several frames; of more than {@link #MAX_TEXT} bytes only the beginning is made, a little
   * longer than that.
   */
  public Outcome withText(TextUse use, int... arguments) throws ScriptError {
    if (prepared.isPresent()) {
      return use.use(prepared.get().text());
    }
    Value[] values = new Value[arguments.length];
    for (int i = 0; i < values.length; i++) {
      values[i] = value(arguments[i]);
    }
    LongOperation conversion = ValueText.begin(MAX_TEXT, values);
    charge(conversion.advance());
    return conversion.done() ? use.use(conversion.result().text()) : new Outcome.Begun(conversion);
  }

  /** What the program runs on. */
  public H host() {
    return host;
  }

  /**
   * Counts computing time of this call that depends on its arguments; what each call takes stands
   * in the {@link Declaration#costs declaration}.
   *
   * @param ns nanoseconds of a usual computer, roughly; not negative
   */
  public void charge(long ns) {
    work.charge(ns);
  }

  public ProgramControl program() {
    return program;
  }

  /** The running frame, counted as {@link Wait#poll} counts: pauses do not pass script time. */
  public long frame() {
    return program.frame();
  }

  /** Whether argument {@code index} was given or has a default. */
  public boolean given(int index) {
    int offset = builtin.signature().receiver().isPresent() ? 1 : 0;
    return index < offset + builtin.signature().parameters().size()
        && registers.tags()[firstArgument + index] != Registers.UNASSIGNED;
  }

  public ValueKind kind(int index) {
    return registers.kind(firstArgument + index);
  }

  /** Whether argument {@code index} is an int. */
  public boolean isInt(int index) {
    return registers.tags()[firstArgument + index] == Registers.INT;
  }

  /** The argument as it is, not copied: copy it before keeping it anywhere. */
  public Value value(int index) {
    return registers.value(firstArgument + index);
  }

  /** A finite or infinite number; an int counts. */
  public double number(int index) throws ScriptError {
    int slot = firstArgument + index;
    if (registers.tags()[slot] > Registers.FLOAT) {
      throw wrongKind(index, FunctionTexts.text("aNumber"));
    }
    return registers.numbers()[slot];
  }

  /** An int, or a float without fraction that fits one. */
  public int integer(int index) throws ScriptError {
    double number = registers.numbers()[firstArgument + index];
    if (registers.tags()[firstArgument + index] > Registers.FLOAT || number != (int) number) {
      throw wrongKind(index, FunctionTexts.text("anInt"));
    }
    return (int) number;
  }

  /** An int within {@code low} .. {@code high}, both allowed. */
  public int integer(int index, int low, int high) throws ScriptError {
    int value = integer(index);
    if (value < low || value > high) {
      throw refuse(index, FunctionTexts.text("range", low, high));
    }
    return value;
  }

  /** A bool; a number counts as true when it is not zero. */
  public boolean bool(int index) throws ScriptError {
    int slot = firstArgument + index;
    if (registers.tags()[slot] > Registers.BOOL) {
      throw wrongKind(index, FunctionTexts.text("aBool"));
    }
    return registers.numbers()[slot] != 0;
  }

  /** A string, one {@code char} a byte. */
  public String text(int index) throws ScriptError {
    if (value(index) instanceof StringValue text) {
      charge(text.readCost() / BYTES_A_NS);
      return text.bytes();
    }
    throw wrongKind(index, FunctionTexts.text("aString"));
  }

  /** A string that is one of some words, in lower case: how a program writes it does not count. */
  public String word(int index) throws ScriptError {
    return text(index).toLowerCase(Locale.ROOT);
  }

  public Pose pose(int index) throws ScriptError {
    int slot = firstArgument + index;
    if (registers.tags()[slot] == Registers.OBJECT
        && registers.objects()[slot] instanceof PoseValue pose) {
      return pose.pose();
    }
    throw wrongKind(index, FunctionTexts.text("aPose"));
  }

  public ListValue list(int index) throws ScriptError {
    if (value(index) instanceof ListValue list) {
      return list;
    }
    throw wrongKind(index, FunctionTexts.text("aList"));
  }

  public MatrixValue matrix(int index) throws ScriptError {
    if (value(index) instanceof MatrixValue matrix) {
      return matrix;
    }
    throw wrongKind(index, FunctionTexts.text("aMatrix"));
  }

  public StructValue struct(int index) throws ScriptError {
    if (value(index) instanceof StructValue struct) {
      return struct;
    }
    throw wrongKind(index, FunctionTexts.text("aStruct"));
  }

  /** A list of numbers of exactly {@code length}, or of any length when that is negative. */
  public double[] numbers(int index, int length) throws ScriptError {
    if (value(index) instanceof NumberList list
        && list.elementKind().isNumber()
        && (length < 0 || list.length() == length)) {
      charge(list.length());
      double[] numbers = new double[list.length()];
      for (int i = 0; i < numbers.length; i++) {
        numbers[i] = list.numberAt(i);
      }
      return numbers;
    }
    throw wrongKind(
        index,
        length < 0 ? FunctionTexts.text("numbers") : FunctionTexts.text("countOfNumbers", length));
  }

  /** Six joint values from a list of six numbers. */
  public Joints joints(int index) throws ScriptError {
    return Joints.of(numbers(index, 6));
  }

  /** The name of the parameter that argument {@code index} is for. */
  private String parameter(int index) {
    int offset = builtin.signature().receiver().isPresent() ? 1 : 0;
    return index < offset ? "self" : builtin.signature().parameters().get(index - offset).name();
  }

  /** An error of this function, e.g. {@code failure("no-solution", "pose is out of reach")}. */
  public ScriptError failure(String code, String what) {
    return new ScriptError(code, builtin.name() + ": " + what);
  }

  /** The refusal of argument {@code index}: {@code sqrt: f is -1, must not be negative}. */
  public ScriptError refuse(int index, String expectation) {
    return new ScriptError(
        "value-out-of-range",
        FunctionTexts.text(
            "refused", builtin.name(), parameter(index), shown(index) + unit(index), expectation));
  }

  /** A blank and the unit of a number that has one. */
  private String unit(int index) {
    int offset = builtin.signature().receiver().isPresent() ? 1 : 0;
    if (index < offset || !kind(index).isNumber()) {
      return "";
    }
    String symbol = builtin.signature().parameters().get(index - offset).unit().symbol();
    return symbol.isEmpty() ? "" : " " + symbol;
  }

  /**
   * The refusal of argument {@code index} for its kind: {@code sqrt: f is string x, must be ...}.
   */
  public ScriptError wrongKind(int index, String expected) {
    return new ScriptError(
        "wrong-type",
        given(index)
            ? FunctionTexts.text(
                "wrongKind",
                builtin.name(),
                parameter(index),
                kind(index).text() + " " + shown(index),
                expected)
            : FunctionTexts.text("missing", builtin.name(), parameter(index), expected));
  }

  private String shown(int index) {
    String text = ValueText.shortened(value(index), MAX_SHOWN);
    return text.isEmpty() ? "\"\"" : text;
  }

  /** Answers without a value. */
  public Outcome answer() {
    registers.tags()[resultSlot] = Registers.NONE;
    return Outcome.Answered.ANSWERED;
  }

  public Outcome answer(double number) {
    registers.setFloat(resultSlot, number);
    return Outcome.Answered.ANSWERED;
  }

  public Outcome answerInt(int number) {
    registers.setInt(resultSlot, number);
    return Outcome.Answered.ANSWERED;
  }

  public Outcome answer(boolean value) {
    registers.setBool(resultSlot, value);
    return Outcome.Answered.ANSWERED;
  }

  public Outcome answer(String bytes) {
    StringValue text = new StringValue(bytes);
    work.take(text.sizeBytes());
    registers.setObject(resultSlot, text);
    return Outcome.Answered.ANSWERED;
  }

  public Outcome answer(Pose pose) {
    return answer(new PoseValue(pose));
  }

  public Outcome answer(Joints joints) {
    return answer(NumberList.of(joints.toArray()));
  }

  /** Begins something that may take several frames. */
  public interface Beginning {
    LongOperation begin() throws ScriptError;
  }

  /** Answers with what comes out of something that may take several frames. */
  public Outcome answerLater(Beginning beginning) throws ScriptError {
    return prepared.isPresent() ? answer(prepared.get()) : new Outcome.Begun(beginning.begin());
  }

  /** Answers with {@code value}, which the caller then owns. */
  public Outcome answer(Value value) {
    work.take(value.sizeBytes());
    registers.set(resultSlot, value);
    return Outcome.Answered.ANSWERED;
  }
}
