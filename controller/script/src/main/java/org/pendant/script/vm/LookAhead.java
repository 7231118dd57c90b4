package org.pendant.script.vm;

import java.util.ArrayList;
import java.util.List;
import org.pendant.language.signature.Type;
import org.pendant.script.function.Builtin;
import org.pendant.script.function.Foreseen;
import org.pendant.script.function.Host;
import org.pendant.script.function.Outcome;
import org.pendant.script.function.ProgramControl;
import org.pendant.script.value.Registers;
import org.pendant.script.value.ScriptError;

/**
 * Look-ahead: runs a copy of a thread to find what it will ask for once its wait is over; a move
 * that blends depends on the moves that follow.
 *
 * <p>The copy computes with the present values. Functions that answer from their arguments or tell
 * the state of the controller do what they always do; functions that only tell something to the
 * outside are passed over; at anything else the copy ends and nothing is known. {@link
 * org.pendant.script.function.Effect} has which is which. What it finds is a guess that shapes how
 * fast a blend is approached; what really comes is decided by the thread itself.
 */
final class LookAhead {
  /** Computing time of a copy, in nanoseconds as {@link Cost} counts them. */
  private static final int BUDGET_NS = 150_000;

  /** How much is foreseen at most. */
  private static final int MAX_FORESEEN = 24;

  /** Interpreted lines that are looked at, which wait after the one under way. */
  private static final int MAX_LINES = 12;

  /** Registers of a program that is too large to copy for each blend. */
  private static final int MAX_REGISTERS = 8000;

  /**
   * Bytes of the lists and the like of a program that has too much data for each blend: what the
   * copy or the program changes later is copied in full.
   */
  private static final int MAX_BYTES = 400_000;

  private final Host host;
  private ProgramRun known;
  private int links;
  private Program.Tables tables;

  LookAhead(Host host) {
    this.host = host;
  }

  /** What built-ins may do to a thread that is run ahead: say what comes. */
  private static final class Ahead implements ProgramControl {
    private final long frame;
    private final List<Foreseen> next = new ArrayList<>();

    Ahead(long frame) {
      this.frame = frame;
    }

    @Override
    public long frame() {
      return frame;
    }

    @Override
    public boolean foresees(Foreseen move) throws ScriptError {
      next.add(move);
      if (move.last() || next.size() == MAX_FORESEEN) {
        throw ended();
      }
      return true;
    }

    @Override
    public boolean foreseesSetting(boolean unchanged) throws ScriptError {
      if (!unchanged) {
        throw ended();
      }
      return true;
    }

    @Override
    public void reachesOutside() throws ScriptError {
      throw ended();
    }

    @Override
    public void pause() {}

    @Override
    public void halt() {}

    @Override
    public Outcome enterInterpreter(boolean clearQueueOnEnter, boolean clearOnEnd)
        throws ScriptError {
      throw ended();
    }

    @Override
    public void endInterpreter() {}

    @Override
    public void clearInterpreter() throws ScriptError {
      throw ended();
    }
  }

  private static ScriptError ended() {
    return new ScriptError("not-foreseen", "what follows cannot be foreseen");
  }

  /** What {@code thread} will ask for once its wait is over, up to one that stops. */
  List<Foreseen> after(ProgramRun run, ScriptThread thread, Interpreter interpreter) {
    Ahead ahead = new Ahead(run.frame());
    try {
      int used = run.registers().size() - interpreter.keptRegisters();
      if (used > MAX_REGISTERS || tooMuchData(run.registers())) {
        return List.of();
      }
      ProgramRun side = run.onTheSide(tables(run), host, ahead);
      ScriptThread worker = copy(thread, side);
      Interpreter.Preview lines = interpreter.preview(thread, LookAhead::foreseeing);
      Processor.Stop stop = side.processor().execute(worker);
      for (int i = 0; i < MAX_LINES && stop == Processor.Stop.INTERPRETED; i++) {
        boolean more = lines.next(side, worker);
        worker.budget = BUDGET_NS;
        stop = more ? side.processor().execute(worker) : Processor.Stop.ENDED;
      }
    } catch (ScriptError e) {
      // as far as it went; if the thread itself comes to fail there it will say so
    }
    return ahead.next;
  }

  private static boolean tooMuchData(Registers registers) {
    long bytes = 0;
    for (int slot = 0; slot < registers.size() && bytes <= MAX_BYTES; slot++) {
      if (registers.tags()[slot] == Registers.OBJECT) {
        bytes += registers.objects()[slot].sizeBytes();
      }
    }
    return bytes > MAX_BYTES;
  }

  private static ScriptThread copy(ScriptThread thread, ProgramRun side) {
    Registers registers = side.registers();
    ScriptThread copy = new ScriptThread(thread.id(), thread.parentId(), side.marks());
    for (int i = 0; i < thread.depth; i++) {
      copy.push(thread.functions[i].original(), thread.bases[i], thread.results[i]);
      copy.pcs[i] = thread.pcs[i];
    }
    copy.segmentStart = thread.segmentStart;
    copy.segmentEnd = thread.segmentEnd;
    copy.budget = BUDGET_NS;
    registers.tags()[thread.base() + thread.waitResult] = Registers.NONE;
    for (int slot = 0; slot < registers.size(); slot++) {
      if (registers.tags()[slot] == Registers.OBJECT) {
        registers.objects()[slot] = registers.objects()[slot].copy();
      }
    }
    return copy;
  }

  private Program.Tables tables(ProgramRun run) {
    if (known != run || links != run.links()) {
      known = run;
      links = run.links();
      tables = foreseeing(run.tables());
    }
    return tables;
  }

  private static Program.Tables foreseeing(Program.Tables tables) {
    List<Builtin<?>> builtins = new ArrayList<>();
    for (Builtin<?> builtin : tables.builtins()) {
      builtins.add(foreseeing(builtin));
    }
    return new Program.Tables(
        tables.functions(),
        tables.staticNames(),
        tables.staticValues(),
        builtins,
        tables.names(),
        tables.nameLists());
  }

  private static <H extends Host> Builtin<H> foreseeing(Builtin<H> builtin) {
    return switch (builtin.effect()) {
      case COMPUTES, ASKS, MOVES, SETS -> builtin;
      case TELLS -> {
        // who is told says at most that it was told, which is what mostly happens
        boolean answers = builtin.signature().result() == Type.BOOL;
        yield builtin.doing(call -> answers ? call.answer(true) : call.answer());
      }
      case ASKS_GOAL -> beforeTheFirstMove(builtin);
      case CHANGES, SENSES ->
          builtin.doing(
              call -> {
                throw ended();
              });
    };
  }

  /** What is right for the first move: the goal of the one that is under way. */
  private static <H extends Host> Builtin<H> beforeTheFirstMove(Builtin<H> builtin) {
    return builtin.doing(
        call -> {
          if (call.program() instanceof Ahead ahead && ahead.next.isEmpty()) {
            return builtin.code().run(call);
          }
          throw ended();
        });
  }
}
