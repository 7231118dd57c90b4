package org.pendant.desktop.session;

import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import org.pendant.controller.Cell;
import org.pendant.controller.ControllerOptions;
import org.pendant.controller.Robot;
import org.pendant.controller.command.Command;
import org.pendant.controller.command.Refusal;
import org.pendant.controller.command.Reply;
import org.pendant.controller.state.ControllerState;
import org.pendant.language.source.Source;
import org.pendant.models.pose.Pose;
import org.pendant.protocols.toolserial.ToolSerialLine;
import org.pendant.recording.Recording;
import org.pendant.recording.lines.LineProfiler;
import org.pendant.recording.replay.Journal;
import org.pendant.script.vm.Program;

/**
 * Session member: one of the controllers of a session, and what the session knows of its runs. Any
 * thread may ask it.
 */
public final class SessionMember {
  /** What the only controller of a session is called. */
  static final String ALONE = "";

  private final String name;
  private final Pose baseInCell;
  private final boolean armless;
  private final Optional<String> address;
  private final SwitchedOn on;
  private final MemberRuns runs;

  /** Made once rather than in each frame. */
  private final FrameListener record;

  private volatile Optional<String> ended = Optional.empty();

  private SessionMember(
      String name,
      Pose baseInCell,
      boolean armless,
      Optional<String> address,
      SwitchedOn on,
      MemberRuns runs) {
    this.name = name;
    this.baseInCell = baseInCell;
    this.armless = armless;
    this.address = address;
    this.on = on;
    this.runs = runs;
    record = on.ring()::take;
  }

  /** One of a cell. */
  static SessionMember of(Cell.Member of, Optional<String> address, SwitchedOn on) {
    return new SessionMember(
        of.name(), of.baseInCell(), of.armless(), address, on, new MemberRuns(on));
  }

  /** One that is alone. */
  static SessionMember alone(SwitchedOn on) {
    return new SessionMember(ALONE, Pose.ZERO, false, Optional.empty(), on, new MemberRuns(on));
  }

  /** Another controller in the place of this one, which nobody drives any more. */
  SessionMember replacedBy(SwitchedOn next) {
    runs.follow(next);
    return with(next);
  }

  /**
   * One that repeats a part of the run of this one, which nobody drives any more.
   *
   * @param lines what the program took in that part
   */
  SessionMember repeatedBy(SwitchedOn next, LineProfiler lines) {
    runs.follow(next, lines);
    return with(next);
  }

  private SessionMember with(SwitchedOn next) {
    return new SessionMember(name, baseInCell, armless, address, next, runs);
  }

  /** What the file of the cell calls it; empty for one that is alone. */
  public String name() {
    return name;
  }

  /** Where its base stands in the frame of the cell. */
  public Pose baseInCell() {
    return baseInCell;
  }

  /** Whether it has no arm: it runs the script of the cell. */
  public boolean armless() {
    return armless;
  }

  /** Where the file of the cell wants its ports; empty where it says nothing. */
  public Optional<String> address() {
    return address;
  }

  /** How it was switched on. What stands around it is in the frame of its base. */
  public ControllerOptions options() {
    return on.options();
  }

  /** The robot. */
  public Robot robot() {
    return on.controller();
  }

  /** The newest snapshot. */
  public ControllerState state() {
    return on.controller().state();
  }

  /** What it did in the last minutes. */
  public Recording recording() {
    return on.ring().recording();
  }

  /** The serial line of its tool connector. */
  public ToolSerialLine toolSerial() {
    return on.tool();
  }

  /** The text of the program that was started last; empty if it is not known any more. */
  public Optional<Source> startedSource() {
    return on.journal().newestProgram().map(Program::source);
  }

  /** Leaves a command for the next frame. */
  public CompletableFuture<Reply> submit(Command command) {
    CompletableFuture<Reply> reply = robot().submit(command);
    // What was left too late for the last frame gets its answer here.
    ended.ifPresent(why -> reply.complete(new Reply.Refused(Refusal.Code.SWITCHED_OFF, why)));
    return reply;
  }

  SwitchedOn on() {
    return on;
  }

  Journal journal() {
    return on.journal();
  }

  /** Records a frame. */
  FrameListener record() {
    return record;
  }

  MemberRuns runs() {
    return runs;
  }

  /** Whoever comes from now on is told {@code why}. */
  void end(String why) {
    ended = Optional.of(why);
  }
}
