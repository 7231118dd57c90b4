package org.pendant.script.vm;

import java.lang.classfile.CodeBuilder;
import java.lang.classfile.Label;
import java.lang.constant.ClassDesc;
import java.lang.constant.ConstantDescs;
import java.lang.constant.MethodTypeDesc;
import java.util.Arrays;
import java.util.Optional;
import java.util.stream.IntStream;
import org.pendant.script.value.BoolValue;
import org.pendant.script.value.FloatValue;
import org.pendant.script.value.IntValue;
import org.pendant.script.value.MatrixValue;
import org.pendant.script.value.NoneValue;
import org.pendant.script.value.NumberList;
import org.pendant.script.value.Registers;
import org.pendant.script.value.Value;
import org.pendant.script.vm.Processor.Stop;

/**
 * JVM code writer: writes bytecode of one {@link TranslatedCode#run} method: how its variables and
 * the registers are reached.
 *
 * <p>Numbers and tags of the busiest local slots are kept in variables of the method as well. Every
 * change goes to both places, so the registers are always up to date, and the variables only have
 * to be loaded again after something else changed a register.
 *
 * <p>The budget of the thread is kept in a variable where a function has loops, and only written
 * back before something else looks at it: a store in every turn would cost as much as a short turn.
 */
final class JvmCode {
  static final ClassDesc PROCESSOR = desc(Processor.class);
  static final ClassDesc STOP = desc(Stop.class);
  static final ClassDesc CODE = desc(TranslatedCode.class);
  static final ClassDesc THREAD = desc(ScriptThread.class);
  static final ClassDesc SLOW_PATH = desc(SlowPath.class);
  static final ClassDesc LIST = desc(NumberList.class);
  static final ClassDesc MATRIX = desc(MatrixValue.class);
  static final ClassDesc VALUE = desc(Value.class);
  private static final ClassDesc REGISTERS = desc(Registers.class);
  private static final ClassDesc ILLEGAL_STATE = desc(IllegalStateException.class);
  private static final ClassDesc INT = ConstantDescs.CD_int;
  private static final ClassDesc DOUBLE = ConstantDescs.CD_double;
  private static final MethodTypeDesc STEP = MethodTypeDesc.of(STOP, THREAD, INT, INT);

  /** The type of {@link TranslatedCode#run}. */
  static final MethodTypeDesc RUN = MethodTypeDesc.of(STOP, PROCESSOR, THREAD, INT, INT);

  /** More slots than this are only found in the registers. */
  private static final int MAX_KEPT = 48;

  // the variables of the method
  private static final int THE_PROCESSOR = 1;
  private static final int THE_THREAD = 2;
  private static final int BASE = 3;
  static final int PC = 4;
  private static final int NUMBERS = 5;
  private static final int TAGS = 6;
  private static final int OBJECTS = 7;
  static final int TAG = 8;
  static final int NUMBER = 9;
  static final int CONTAINER = 11;
  static final int CALLEE = 12;
  private static final int BUDGET = 13;
  private static final int FIRST_KEPT = 14;
  private static final int MARKS = FIRST_KEPT + 3 * MAX_KEPT;
  private static final int TURNS = MARKS + 1;

  private final CodeBuilder code;
  private final ScriptFunction function;
  private final Program.Tables tables;

  /** The variable that keeps the number of each local slot, its tag after it; 0 for none. */
  private final int[] kept;

  /** Whether the function itself counts what it costs. */
  private final boolean counts;

  /** Whether the function marks what it reaches. */
  private final boolean marks;

  /** Whether it has loops. */
  private final boolean loops;

  /** Continues with the instruction in variable {@link #PC}. */
  private final Label resume;

  /**
   * @param uses how often each local slot is read as a number
   */
  JvmCode(CodeBuilder code, ScriptFunction function, Program.Tables tables, int[] uses) {
    this.code = code;
    this.function = function;
    this.tables = tables;
    counts = Arrays.stream(function.instructions()).anyMatch(JvmCode::isCounted);
    marks =
        Arrays.stream(function.instructions()).anyMatch(w -> Instruction.operation(w) == Op.MARK);
    loops =
        IntStream.range(0, function.instructions().length)
            .anyMatch(pc -> LoopInstructions.backTo(function.instructions()[pc], pc) >= 0);
    resume = code.newLabel();
    kept = new int[uses.length];
    int[] busiest = uses.clone();
    Arrays.sort(busiest);
    int least = Math.max(1, uses.length > MAX_KEPT ? busiest[uses.length - MAX_KEPT] : 1);
    int next = FIRST_KEPT;
    for (int i = 0; i < uses.length && next < FIRST_KEPT + 3 * MAX_KEPT; i++) {
      if (uses[i] >= least) {
        kept[i] = next;
        next += 3;
      }
    }
  }

  /** Whether instruction {@code w} itself counts what the function costs. */
  static boolean isCounted(long w) {
    return switch (Instruction.operation(w)) {
      case Op.LOOP, Op.LOOP_IF_LESS, Op.LOOP_IF_LESS_OR_EQUAL, Op.STRETCH -> true;
      default -> false;
    };
  }

  static ClassDesc desc(Class<?> type) {
    return ClassDesc.ofDescriptor(type.descriptorString());
  }

  CodeBuilder code() {
    return code;
  }

  // --- constants

  private Optional<Value> constant(int operand) {
    return Instruction.isLocal(operand) ? Optional.empty() : tables.constant(operand);
  }

  /** The tag of an operand that never changes; -1 for any other. */
  int knownTag(int operand) {
    return constant(operand)
        .map(
            value ->
                (int)
                    switch (value) {
                      case IntValue i -> Registers.INT;
                      case FloatValue f -> Registers.FLOAT;
                      case BoolValue b -> Registers.BOOL;
                      case NoneValue n -> Registers.NONE;
                      default -> Registers.OBJECT;
                    })
        .orElse(-1);
  }

  /** The number of an operand whose {@link #knownTag} is one of a number or bool. */
  double knownNumber(int operand) {
    return switch (constant(operand).orElseThrow()) {
      case IntValue i -> i.value();
      case FloatValue f -> f.value();
      case BoolValue b -> b.value() ? 1 : 0;
      default -> throw new IllegalArgumentException("operand " + operand + " is no number");
    };
  }

  boolean isVariable(int operand) {
    return !Instruction.isLocal(operand) || Instruction.index(operand) < function.variableCount();
  }

  private int keeper(int operand) {
    return Instruction.isLocal(operand) ? kept[Instruction.index(operand)] : 0;
  }

  // --- reading

  void address(int operand) {
    int index = Instruction.index(operand);
    if (!Instruction.isLocal(operand)) {
      code.loadConstant(index);
    } else {
      code.iload(BASE);
      if (index > 0) {
        code.loadConstant(index).iadd();
      }
    }
  }

  /** Pushes the tag of {@code operand}. */
  void tag(int operand) {
    int known = knownTag(operand);
    int keeper = keeper(operand);
    if (known >= 0) {
      code.loadConstant(known);
    } else if (keeper > 0) {
      code.iload(keeper + 2);
    } else {
      code.aload(TAGS);
      address(operand);
      code.baload();
    }
  }

  /** Pushes the number of {@code operand}. */
  void number(int operand) {
    int known = knownTag(operand);
    int keeper = keeper(operand);
    if (known >= 0 && known <= Registers.BOOL) {
      code.loadConstant(knownNumber(operand));
    } else if (keeper > 0) {
      code.dload(keeper);
    } else {
      code.aload(NUMBERS);
      address(operand);
      code.daload();
    }
  }

  /** Pushes the object of {@code operand}. */
  void object(int operand) {
    code.aload(OBJECTS);
    address(operand);
    code.aaload();
  }

  // --- writing

  /** Stores the number in variable {@link #NUMBER} with the tag that {@code tag} pushes. */
  void store(int operand, Runnable tag) {
    code.aload(NUMBERS);
    address(operand);
    code.dload(NUMBER).dastore();
    storeTag(operand, tag);
    int keeper = keeper(operand);
    if (keeper > 0) {
      code.dload(NUMBER).dstore(keeper);
    }
  }

  void storeTag(int operand, Runnable tag) {
    int keeper = keeper(operand);
    Label same = code.newLabel();
    if (keeper > 0 && isVariable(operand)) {
      // most variables keep their type, and a comparison costs less than a store with its checks
      tag.run();
      code.iload(keeper + 2).if_icmpeq(same);
    }
    code.aload(TAGS);
    address(operand);
    tag.run();
    code.bastore();
    if (keeper > 0) {
      tag.run();
      code.istore(keeper + 2);
    }
    code.labelBinding(same);
  }

  void copyObject(int target, int source) {
    code.aload(OBJECTS);
    address(target);
    object(source);
    code.aastore();
  }

  /** Loads what is kept of {@code operand} after something else may have changed it. */
  void reload(int operand) {
    int keeper = keeper(operand);
    if (keeper > 0) {
      code.aload(NUMBERS);
      address(operand);
      code.daload().dstore(keeper);
      code.aload(TAGS);
      address(operand);
      code.baload().istore(keeper + 2);
    }
  }

  /** Fetches the register arrays, which may have been replaced. */
  void reloadArrays() {
    code.aload(THE_PROCESSOR)
        .invokevirtual(PROCESSOR, "registers", MethodTypeDesc.of(REGISTERS))
        .dup()
        .invokevirtual(REGISTERS, "numbers", MethodTypeDesc.of(DOUBLE.arrayType()))
        .astore(NUMBERS)
        .dup()
        .invokevirtual(REGISTERS, "tags", MethodTypeDesc.of(ConstantDescs.CD_byte.arrayType()))
        .astore(TAGS)
        .invokevirtual(REGISTERS, "objects", MethodTypeDesc.of(VALUE.arrayType()))
        .astore(OBJECTS);
  }

  /** The beginning of the method: {@code start} follows for instruction 0, a switch for others. */
  void prologue(Label start) {
    code.labelBinding(resume);
    reloadArrays();
    if (loops) {
      code.aload(THE_PROCESSOR)
          .invokevirtual(PROCESSOR, "takeTurnsUntilLoop", MethodTypeDesc.of(INT))
          .istore(TURNS);
    }
    loadBudget();
    if (marks) {
      code.aload(THE_PROCESSOR)
          .invokevirtual(PROCESSOR, "marks", MethodTypeDesc.of(ConstantDescs.CD_byte.arrayType()))
          .astore(MARKS);
    }
    for (int i = 0; i < function.variableCount(); i++) {
      reload(Instruction.local(i));
    }
    for (int i = function.variableCount(); i < kept.length; i++) {
      if (kept[i] > 0) {
        code.dconst_0().dstore(kept[i]).iconst_0().istore(kept[i] + 2);
      }
    }
    code.iload(PC).ifeq(start);
    for (int i = function.variableCount(); i < kept.length; i++) {
      reload(Instruction.local(i));
    }
  }

  /** Marks coverage {@code slot} as reached. */
  void mark(int slot) {
    code.aload(MARKS).loadConstant(slot).iconst_1().bastore();
  }

  // --- what is not done here

  private void loadBudget() {
    if (counts) {
      code.aload(THE_THREAD).getfield(THREAD, "budget", INT).istore(BUDGET);
    }
  }

  private void writeBudgetBack() {
    if (counts) {
      code.aload(THE_THREAD).iload(BUDGET).putfield(THREAD, "budget", INT);
    }
  }

  private void step(String method, int pc, MethodTypeDesc type) {
    writeBudgetBack();
    code.aload(THE_PROCESSOR)
        .invokevirtual(PROCESSOR, "slow", MethodTypeDesc.of(SLOW_PATH))
        .aload(THE_THREAD)
        .iload(BASE)
        .loadConstant(pc + 1)
        .invokevirtual(SLOW_PATH, method, type);
    loadBudget();
  }

  /**
   * Executes instruction {@code pc} in full generality and pushes the {@link Stop}: exhausted when
   * the thread has stopped before the instruction.
   */
  void slow(int pc) {
    step("run", pc, STEP);
  }

  /** {@link #slow} of an addition. */
  void slowAdd(int pc) {
    step("add", pc, STEP);
  }

  /** {@link #slow} of a call of a built-in function. */
  void slowCall(int pc) {
    step("callBuiltin", pc, STEP);
  }

  /** Pushes whether what instruction {@code pc} compares is equal, or {@link SlowPath#STOPPED}. */
  void slowEqual(int pc) {
    step("equal", pc, STEP.changeReturnType(INT));
  }

  void stop(Stop stop) {
    code.getstatic(STOP, stop.name(), STOP);
  }

  /** Throws, because the method was entered at an instruction that no thread can stop before. */
  void unknownResumePoint() {
    code.iload(PC).invokestatic(CODE, "unknown", MethodTypeDesc.of(ILLEGAL_STATE, INT)).athrow();
  }

  /** Counts {@code costNs} and jumps to {@code exhausted} when the budget does not suffice. */
  void count(int costNs, Label exhausted) {
    code.iload(BUDGET).loadConstant(costNs).isub().dup().istore(BUDGET).iflt(exhausted);
  }

  /** Returns from the method: the turn continues with instruction {@code pc} in the next frame. */
  void exhausted(int pc) {
    writeBudgetBack();
    code.aload(THE_THREAD)
        .loadConstant(pc)
        .invokestatic(PROCESSOR, "exhausted", MethodTypeDesc.of(STOP, THREAD, INT))
        .areturn();
  }

  /** Counts a turn of a loop and jumps to {@code direct} now and then. */
  void countTurn(Label direct) {
    code.iinc(TURNS, -1);
    code.iload(TURNS).ifle(direct);
  }

  /**
   * Goes on directly with the loop that begins a turn at {@code pc}, if possible; what follows is
   * for one that the thread has left in another way than this method continues with.
   */
  void loop(int pc) {
    Label left = code.newLabel();
    writeBudgetBack();
    code.aload(THE_PROCESSOR)
        .aload(THE_THREAD)
        .iload(BASE)
        .loadConstant(pc)
        .invokevirtual(PROCESSOR, "loop", MethodTypeDesc.of(INT, THREAD, INT, INT))
        .dup()
        .istore(PC)
        .iflt(left)
        .goto_(resume)
        .labelBinding(left);
  }

  /** Pushes a frame and the callee's code, or null. */
  void enter(int pc, int number, int offset, int result) {
    writeBudgetBack();
    code.aload(THE_PROCESSOR)
        .aload(THE_THREAD)
        .iload(BASE)
        .loadConstant(pc + 1)
        .loadConstant(number)
        .loadConstant(offset)
        .loadConstant(result)
        .invokevirtual(
            PROCESSOR, "enter", MethodTypeDesc.of(CODE, THREAD, INT, INT, INT, INT, INT));
  }

  /** Pushes why there was no code to run. */
  void refusal() {
    code.aload(THE_PROCESSOR).invokevirtual(PROCESSOR, "refusal", MethodTypeDesc.of(STOP));
  }

  private void base() {
    code.aload(THE_THREAD).invokevirtual(THREAD, "base", MethodTypeDesc.of(INT));
  }

  /** Runs the code in variable {@link #CALLEE} and pushes its {@link Stop}. */
  void runCallee() {
    code.aload(CALLEE).aload(THE_PROCESSOR).aload(THE_THREAD);
    base();
    code.iconst_0().invokevirtual(CODE, "run", RUN);
  }

  /** Continues after a call, which may have moved this frame. */
  void returned(int result) {
    reloadArrays();
    loadBudget();
    base();
    code.istore(BASE);
    reload(result);
  }

  /** Leaves the frame with the value of {@code operand}, tagged as {@code tag} pushes. */
  void leave(int operand, Runnable tag) {
    writeBudgetBack();
    code.aload(THE_PROCESSOR).aload(THE_THREAD);
    tag.run();
    number(operand);
    address(operand);
    code.invokevirtual(PROCESSOR, "leave", MethodTypeDesc.of(STOP, THREAD, INT, DOUBLE, INT))
        .areturn();
  }
}
