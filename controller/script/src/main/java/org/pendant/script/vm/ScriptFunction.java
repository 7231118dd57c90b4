package org.pendant.script.vm;

import java.util.List;
import java.util.function.IntPredicate;
import org.pendant.language.check.FunctionScope;
import org.pendant.language.source.Source;
import org.pendant.language.source.SourceRange;
import org.pendant.script.value.Registers;

/**
 * Script function: one compiled function, thread or main level.
 *
 * <p>Its slots stand in this order: parameters, other local variables, temporaries.
 */
final class ScriptFunction {
  private static final int DIRECT_CHANCES = 1000;

  /** Most direct entries of a function, two for each combination of tags. */
  private static final int MAX_DIRECT = 16;

  /** Most loop entries of a function, one for each place and combination of tags. */
  private static final int MAX_LOOPS = 32;

  private final String name;
  private final Source source;
  private final long[] instructions;

  /** What is interpreted: the instructions, with traps among them in a trapped form. */
  private final long[] code;

  private final int[] rangeStarts;
  private final int[] rangeEnds;
  private final StatementTable statements;
  private final int paid;
  private final UnmarkedStatements unmarked;
  private final int parameterCount;
  private final List<String> variables;
  private final int slotCount;
  private final int callNs;
  private final FunctionScope scope;

  /** What a trapped form was made of; itself for any other. */
  private final ScriptFunction original;

  /** Calls and turns so far, while interpreted; only roughly where several machines count. */
  int heat;

  /** No translation will be found for this. */
  volatile boolean untranslatable;

  // Not volatile, which would cost a tenth of every call: a translation has no fields that a racing
  // reader could see too early, and one who reads the old value interprets a little longer.
  private TranslatedCode translated;

  /**
   * How many calls may still find that they can not be direct, before that is not tried any more;
   * roughly where several machines count.
   */
  private int directChances;

  /** For calls with arguments of certain tags, the newest first. */
  private DirectEntry direct;

  /** For loops of it with variables of certain tags, the newest first. */
  private LoopEntry loops;

  /**
   * @param paid how many of the instructions are not free
   * @param unmarked statements that leave no mark of coverage
   */
  ScriptFunction(
      String name,
      Source source,
      long[] code,
      int[] rangeStarts,
      int[] rangeEnds,
      StatementTable statements,
      int paid,
      UnmarkedStatements unmarked,
      int parameterCount,
      List<String> variables,
      int slotCount,
      FunctionScope scope) {
    this.name = name;
    this.source = source;
    this.instructions = code;
    this.code = code;
    this.rangeStarts = rangeStarts;
    this.rangeEnds = rangeEnds;
    this.statements = statements;
    this.paid = paid;
    this.unmarked = unmarked;
    this.parameterCount = parameterCount;
    this.variables = List.copyOf(variables);
    this.slotCount = slotCount;
    callNs = Cost.call(paid);
    directChances = hasCallsOrLoops(code) ? DIRECT_CHANCES : 0;
    this.scope = scope;
    original = this;
  }

  private ScriptFunction(ScriptFunction original) {
    name = original.name;
    source = original.source;
    instructions = original.instructions;
    code = instructions.clone();
    rangeStarts = original.rangeStarts;
    rangeEnds = original.rangeEnds;
    statements = original.statements;
    paid = original.paid;
    unmarked = original.unmarked;
    parameterCount = original.parameterCount;
    variables = original.variables;
    slotCount = original.slotCount;
    callNs = original.callNs;
    scope = original.scope;
    untranslatable = true;
    this.original = original;
  }

  /** A form of this function for one run, which is always interpreted and can take traps. */
  ScriptFunction trappedForm() {
    return new ScriptFunction(original);
  }

  /** The function as it was compiled, whose trapped form this may be. */
  ScriptFunction original() {
    return original;
  }

  /** Puts traps before the wanted statements of a trapped form, and before no others. */
  void trap(IntPredicate statementNumber) {
    System.arraycopy(instructions, 0, code, 0, code.length);
    for (int i = 0; i < statements.size(); i++) {
      if (statementNumber.test(i)) {
        code[statements.pc(i)] = Instruction.of(Op.TRAP, 0, 0, 0);
      }
    }
  }

  StatementTable statements() {
    return statements;
  }

  String name() {
    return name;
  }

  Source source() {
    return source;
  }

  /** The translation that was installed; null when there is none. */
  TranslatedCode translated() {
    return translated;
  }

  void install(TranslatedCode translation) {
    translated = translation;
  }

  /** Without any, a direct call takes as long as any other. */
  private static boolean hasCallsOrLoops(long[] instructions) {
    for (long w : instructions) {
      switch (Instruction.operation(w)) {
        case Op.CALL, Op.LOOP, Op.LOOP_IF_LESS, Op.LOOP_IF_LESS_OR_EQUAL -> {
          return true;
        }
        default -> {}
      }
    }
    return false;
  }

  /** Whether calls may be direct. */
  boolean mayBeDirect() {
    return directChances > 0;
  }

  /** Calls could not be direct: with objects, or since code for them ends too soon. */
  void wasNotDirect(int calls) {
    directChances -= calls;
  }

  /**
   * What it is called directly with, for arguments of certain tags and such global variables in the
   * registers; null when there is none.
   */
  DirectEntry direct(long key, Registers registers) {
    DirectEntry entry = direct;
    while (entry != null && (entry.key() != key || !entry.globals().are(registers))) {
      entry = entry.next();
    }
    return entry;
  }

  /** Notes that code for such arguments is being made; false when that must not be tried. */
  synchronized boolean triesDirect(long key, GlobalTags globals) {
    if (direct != null && direct.count() >= MAX_DIRECT) {
      return false;
    }
    direct = new DirectEntry(key, globals, null, 0, direct);
    return true;
  }

  /** Takes {@code code} for calls with arguments that {@code key} tells of. */
  synchronized void installDirect(long key, GlobalTags globals, DirectCode code, int slots) {
    direct = new DirectEntry(key, globals, code, slots, direct);
  }

  /** Code for a turn at {@code pc} with such variables in the registers; null if not tried. */
  LoopEntry loop(int pc, Registers registers, int base) {
    LoopEntry entry = loops;
    while (entry != null && !entry.suits(pc, registers, base)) {
      entry = entry.next();
    }
    return entry;
  }

  /** Notes that code for a loop is being made; null when that must not be tried. */
  synchronized LoopEntry triesLoop(LoopRegion region, int[] tags) {
    if (loops != null && loops.count() == MAX_LOOPS) {
      return null;
    }
    loops = new LoopEntry(region, tags, loops);
    return loops;
  }

  /** What is interpreted, traps included. */
  long[] code() {
    return code;
  }

  /** What was compiled. */
  long[] instructions() {
    return instructions;
  }

  /** How many of the instructions are not free. */
  int paid() {
    return paid;
  }

  /** Statements that leave no mark of coverage. */
  UnmarkedStatements unmarked() {
    return unmarked;
  }

  int parameterCount() {
    return parameterCount;
  }

  /** Parameters and local variables, in the order of their slots. */
  List<String> variables() {
    return variables;
  }

  int variableCount() {
    return variables.size();
  }

  int slotCount() {
    return slotCount;
  }

  /** Whether nothing is left to do from instruction {@code pc} on but to return. */
  boolean returnsFrom(int pc) {
    int at = pc;
    while (passes(instructions[at])) {
      boolean jump = Instruction.operation(instructions[at]) == Op.JUMP;
      at += 1 + (jump ? Instruction.distance(instructions[at]) : 0);
    }
    int operation = Instruction.operation(instructions[at]);
    return operation == Op.RETURN || operation == Op.RETURN_NONE;
  }

  /** Leads on to another instruction, and does nothing else. */
  private static boolean passes(long instruction) {
    return switch (Instruction.operation(instruction)) {
      case Op.STRETCH, Op.MARK -> true;
      case Op.JUMP -> Instruction.distance(instruction) >= 0;
      default -> false;
    };
  }

  /** What a call costs, see {@link Cost}. */
  int callNs() {
    return callNs;
  }

  /** What its names mean, for statements that are linked into it later. */
  FunctionScope scope() {
    return scope;
  }

  /** What instruction {@code pc} was compiled from. */
  SourceRange range(int pc) {
    int at = Math.clamp(pc, 0, rangeStarts.length - 1);
    return new SourceRange(rangeStarts[at], rangeEnds[at]);
  }

  /** The 1-based line of instruction {@code pc}. */
  int line(int pc) {
    return source.line(rangeStarts[Math.clamp(pc, 0, rangeStarts.length - 1)]);
  }
}
