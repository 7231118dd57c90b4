package org.pendant.controller;

import static org.pendant.controller.ControllerTexts.text;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.ArrayBlockingQueue;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.TimeUnit;
import org.pendant.controller.box.BoxClock;
import org.pendant.controller.command.Command;
import org.pendant.controller.command.CommandHandler;
import org.pendant.controller.command.Refusal;
import org.pendant.controller.command.Reply;
import org.pendant.controller.message.MessageLog;
import org.pendant.language.source.SourceRange;
import org.pendant.script.debug.Debugger;
import org.pendant.script.vm.Interpreter;
import org.pendant.script.vm.ScriptFailure;

/**
 * Command queue: takes commands from any thread and has their handlers carry them out in the frame
 * loop, in their order. Secondary programs run after the primary one in the frame.
 */
final class CommandQueue {
  /** Most commands between two frames; more are refused. */
  static final int CAPACITY = 1024;

  /** Most secondary programs in a frame; more are refused. */
  static final int MAX_SECONDARIES = 8;

  /** Most lines for interpreter mode that are checked in a frame; more wait for the next ones. */
  static final int MAX_LINES = 16;

  private final BoxClock clock;
  private final MessageLog log;
  private final Interpreter interpreter;
  private final ProgramCommandHandler programs;

  /** Who carries out a command, by its class. */
  private final Map<Class<?>, CommandHandler<?>> handlers = new HashMap<>();

  private final BlockingQueue<PendingCommand> arrived = new ArrayBlockingQueue<>(CAPACITY);
  private final List<PendingCommand> secondaries = new ArrayList<>();
  private final Deque<PendingCommand> lines = new ArrayDeque<>();
  private final List<Answered> answered = new ArrayList<>();
  private int linesOfFrame;
  private CommandJournal journal = (frame, turn, command) -> {};
  private volatile Runnable wake = () -> {};
  private long frame;
  private long turn;

  private record Answered(PendingCommand command, Reply reply) {}

  CommandQueue(
      BoxClock clock,
      MessageLog log,
      Interpreter interpreter,
      Debugger debugger,
      ProgramCommandHandler programs,
      List<CommandHandler<?>> others) {
    this.clock = clock;
    this.log = log;
    this.interpreter = interpreter;
    this.programs = programs;
    add(programs);
    others.forEach(this::add);
    debugger.noteIn(request -> journal.note(frame, turn, new DebugCommand.Debug(request)));
  }

  private void add(CommandHandler<?> handler) {
    for (Class<?> each : handler.family().getPermittedSubclasses()) {
      handlers.put(each, handler);
    }
  }

  /** Has {@code journal} told of every command from now on. */
  void noteIn(CommandJournal journal) {
    this.journal = journal;
  }

  /** Has {@code wake} run whenever a command has arrived, by the thread that brought it. */
  void wakeBy(Runnable wake) {
    this.wake = wake;
  }

  /** Any thread: leaves a command for the next frame. */
  PendingCommand post(Command command) {
    PendingCommand pending = new PendingCommand(command, arrived::remove);
    if (arrived.offer(pending)) {
      wake.run();
    } else {
      pending.reply().complete(full());
    }
    return pending;
  }

  /** Any thread that may wait: leaves a command and waits for its reply. */
  Reply ask(Command command, Deadline deadline) {
    PendingCommand pending = new PendingCommand(command, arrived::remove);
    long beganNs = System.nanoTime();
    try {
      if (!arrived.offer(pending, deadline.placeNs(), TimeUnit.NANOSECONDS)) {
        return full();
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      return PendingCommand.INTERRUPTED;
    }
    wake.run();
    return pending.await(deadline, System.nanoTime() - beganNs);
  }

  /**
   * Carries out what has arrived, in its order and at most {@link #CAPACITY} at a time.
   *
   * @param afterEach runs after each command: the next one may end what this one has begun
   */
  void drain(Runnable afterEach) {
    countTurn();
    linesOfFrame = 0;
    interpretWaiting();
    for (int left = CAPACITY; left > 0; left--) {
      PendingCommand next = arrived.poll();
      if (next == null) {
        return;
      }
      if (!next.begin()) {
        continue;
      }
      if (!(next.command() instanceof DebugCommand.Debug)) {
        // what a debugger is asked it says itself
        journal.note(frame, turn, next.command());
      }
      if (next.command() instanceof ProgramCommand.RunSecondary) {
        letWaitBeside(next);
      } else if (next.command() instanceof InterpreterCommand.Interpret && mustWait()) {
        letWait(next);
      } else {
        if (next.command() instanceof ProgramCommand.ReplaceProgram && programs.makeRoom()) {
          afterEach.run();
        }
        answer(next);
        afterEach.run();
      }
    }
  }

  /** Leaves what has arrived for the next time. */
  void leave() {
    countTurn();
  }

  private void countTurn() {
    turn = clock.frame() == frame ? turn + 1 : 0;
    frame = clock.frame();
  }

  private void letWaitBeside(PendingCommand secondary) {
    if (secondaries.size() < MAX_SECONDARIES) {
      secondaries.add(secondary);
    } else {
      String why = text("secondariesOfFrame", MAX_SECONDARIES);
      answered.add(new Answered(secondary, new Reply.Refused(Refusal.Code.LIMIT, why)));
    }
  }

  /** Whether a line for interpreter mode cannot be checked yet, or others are before it. */
  private boolean mustWait() {
    return !lines.isEmpty() || !mayInterpret();
  }

  private boolean mayInterpret() {
    return linesOfFrame < MAX_LINES && !interpreter.clearing();
  }

  private void letWait(PendingCommand line) {
    if (lines.size() < Interpreter.MAX_QUEUED) {
      lines.add(line);
    } else {
      answered.add(
          new Answered(
              line,
              new Reply.Interpreted(
                  new Interpreter.Response.Discarded(
                      text("statementsWaiting", Interpreter.MAX_QUEUED)))));
    }
  }

  private void interpretWaiting() {
    while (!lines.isEmpty() && mayInterpret()) {
      answer(lines.remove());
    }
  }

  /** Runs the secondary programs that have arrived. */
  void runSecondaries() {
    if (!secondaries.isEmpty()) {
      secondaries.forEach(this::answer);
      secondaries.clear();
    }
  }

  /** Refuses the secondary programs that have arrived. */
  void refuseSecondaries(String why) {
    for (PendingCommand next : secondaries) {
      answered.add(new Answered(next, new Reply.Refused(Refusal.Code.DEBUGGER, why)));
    }
    secondaries.clear();
  }

  /** Hands out the replies; the snapshot that shows the effect is published. */
  void reply() {
    if (answered.isEmpty()) {
      return;
    }
    List<Answered> ready = List.copyOf(answered);
    answered.clear();
    ready.forEach(each -> each.command().reply().complete(each.reply()));
  }

  private void answer(PendingCommand next) {
    if (next.command() instanceof InterpreterCommand.Interpret) {
      linesOfFrame++;
    }
    answered.add(new Answered(next, carryOut(next.command())));
  }

  private static Reply full() {
    return new Reply.Busy(text("commandsOfFrame", CAPACITY));
  }

  private Reply carryOut(Command command) {
    try {
      CommandHandler<?> handler = handlers.get(command.getClass());
      if (handler == null) {
        throw new IllegalStateException("no handler carries out " + command);
      }
      return carryOut(handler, command);
    } catch (IllegalArgumentException e) {
      return new Reply.Refused(Refusal.Code.INVALID, e.getMessage());
    } catch (RuntimeException | StackOverflowError | OutOfMemoryError e) {
      log.internalError(e);
      return new Reply.Failed(
          new ScriptFailure(
              "internal-error", text("internalError", e), new SourceRange(0, 0), 1, 1, List.of()));
    }
  }

  private static <C extends Command> Reply carryOut(CommandHandler<C> handler, Command command) {
    return handler.carryOut(handler.family().cast(command));
  }
}
