package org.pendant.controller;

import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.function.Consumer;
import org.pendant.controller.box.Inertia;
import org.pendant.controller.box.ToolCentre;
import org.pendant.controller.eip.AssemblyData;
import org.pendant.controller.eip.AssemblyPair;
import org.pendant.controller.file.ProgramsFolder;
import org.pendant.controller.freedrive.FreeAxes;
import org.pendant.controller.freedrive.FreedriveFrame;
import org.pendant.controller.installation.Installation;
import org.pendant.controller.installation.InstallationCheck;
import org.pendant.controller.io.InputOwners;
import org.pendant.controller.io.SignalWrite;
import org.pendant.controller.jog.JogMove;
import org.pendant.controller.jog.Jogging;
import org.pendant.controller.message.Answer;
import org.pendant.controller.message.LogEntry;
import org.pendant.controller.rtde.InputRecipe;
import org.pendant.controller.rtde.InputUpdate;
import org.pendant.controller.safety.SafetyInput;
import org.pendant.controller.world.HandGrip;
import org.pendant.controller.world.Vector3;
import org.pendant.models.dynamics.Payload;
import org.pendant.models.pose.Wrench;
import org.pendant.script.debug.Debugger;
import org.pendant.script.variables.VariablePath;
import org.pendant.script.variables.VariableTracer;
import org.pendant.script.vm.InterpretedLine;
import org.pendant.script.vm.Program;

/** What somebody outside asks of a controller; carried out at the begin of the next frame. */
public sealed interface Command {

  /**
   * Starts a program; refused while another one runs or is paused.
   *
   * @param folder from which it may read files; empty for that of {@link SetProgramsFolder}
   */
  record StartProgram(Program program, Optional<ProgramsFolder> folder) implements Command {
    /** A program that reads files where all do. */
    public StartProgram(Program program) {
      this(program, Optional.empty());
    }
  }

  /**
   * Starts a program that somebody sent to a port: the one that runs or is paused ends, and the new
   * one starts in the same frame. An arm that still moves goes on evenly when the program begins
   * with speeds, servos or a stop; moves wait until it has come to rest on the old path.
   *
   * <p>Refused during any stop of the safety functions, in recovery, and when the controller has
   * been shut down; what ran goes on then. Without power the program starts all the same, and fails
   * at its first motion.
   */
  record ReplaceProgram(Program program) implements Command {}

  /**
   * Programs that start from now on and bring no folder of their own may read files in this one.
   */
  record SetProgramsFolder(ProgramsFolder folder) implements Command {}

  /**
   * Makes the controller what an installation says, in place of what was. Refused while a program
   * runs or is paused or the arm moves, and when {@link InstallationCheck} finds something wrong.
   * Where the safety configuration differs the arm is powered off, as a real one is.
   */
  record ApplyInstallation(Installation installation) implements Command {}

  /**
   * A fieldbus scanner that has written inputs does so no longer; what follows is up to the
   * installation.
   *
   * @param who it was, for the log
   */
  record ScannerLost(String who) implements Command {}

  /** Ends the program; the arm comes to rest on its path. */
  record StopProgram() implements Command {}

  /** Holds script time; the arm comes to rest on its path. */
  record PauseProgram() implements Command {}

  /** Goes on after a pause; a popup that caused it closes. */
  record ResumeProgram() implements Command {}

  /**
   * Runs a secondary program beside the primary one, to its end (manual 12). Refused as {@link
   * ReplaceProgram} is, when too many others came in the same frame, and while a debugger holds it;
   * the answer to one that ends with an error is {@link Reply.Failed}.
   *
   * @param folder from which it may read files; empty for that of {@link SetProgramsFolder}
   */
  record RunSecondary(Program program, Optional<ProgramsFolder> folder) implements Command {
    /** A program that reads files where all do. */
    public RunSecondary(Program program) {
      this(program, Optional.empty());
    }
  }

  /**
   * Sets a digital input.
   *
   * @param name such as {@code digital_in[0]}, {@code configurable_in[3]} or {@code tool_in[1]}
   */
  record SetInput(String name, boolean level) implements Command {}

  /**
   * Changes signals, all of them or, when one is refused, none. A signal that somebody else has
   * taken is refused with the owner's name. By hand, outputs are refused while a program runs or is
   * paused.
   *
   * @param writer who asks: the name under which {@link ClaimSignal} takes signals, or {@link
   *     InputOwners#BY_HAND}
   */
  record WriteSignals(String writer, List<SignalWrite> writes) implements Command {
    /** Copies the list. */
    public WriteSignals {
      writes = List.copyOf(writes);
    }

    /** A change by hand. */
    public WriteSignals(SignalWrite write) {
      this(InputOwners.BY_HAND, List.of(write));
    }
  }

  /**
   * Writes what a package of an RTDE client asks for, all of it or, when somebody else has taken
   * one of its inputs, nothing; refused with the owner's name then. Also counts for watchdogs.
   *
   * @param writer the name under which {@link ClaimInputs} has taken the inputs
   */
  record WriteInputs(String writer, InputUpdate update) implements Command {}

  /**
   * Takes the inputs of a recipe, so that nobody else may write them: all of them or, when one is
   * taken, none. {@link ReleaseSignals} gives them back.
   *
   * @param owner such as an RTDE client
   * @param answer is told in the frame loop which inputs are taken by somebody else, by their names
   */
  record ClaimInputs(String owner, InputRecipe recipe, Consumer<Set<String>> answer)
      implements Command {}

  /**
   * Takes a signal, so that nobody else may write it; refused with the owner's name when it is
   * taken.
   *
   * @param owner such as an RTDE client
   * @param signal see {@link InputOwners}
   */
  record ClaimSignal(String owner, String signal) implements Command {}

  /**
   * Makes the assemblies of an EtherNet/IP connection (manual 21.1.1); refused when one of them
   * exists with another size or in another pair.
   */
  record ConfigureAssemblies(AssemblyPair pair) implements Command {}

  /**
   * An EtherNet/IP scanner has written an assembly; refused when there is no such instance or it
   * has another size.
   */
  record ReceiveAssembly(int instance, AssemblyData data) implements Command {}

  /** Gives back all signals that {@code owner} has taken. */
  record ReleaseSignals(String owner) implements Command {}

  /**
   * Turns an encoder by a simulated belt, without pulses; one that no program has set up counts
   * from then on.
   *
   * @param index 0 or 1
   * @param ticksPerS -1,000,000 to 1,000,000; 0 for a belt that stands
   */
  record RunEncoder(int index, double ticksPerS) implements Command {}

  /**
   * Moves the speed slider; refused with the owner's name while somebody else has taken it.
   *
   * @param writer who asks, as in {@link WriteSignals}; it is taken as {@link
   *     InputOwners#SPEED_SLIDER}
   * @param fraction 0 to 1
   */
  record SetSpeedFraction(String writer, double fraction) implements Command {
    /** A change by hand. */
    public SetSpeedFraction(double fraction) {
      this(InputOwners.BY_HAND, fraction);
    }
  }

  /** Closes a popup; a program that it paused goes on. */
  record AnswerPopup(long number) implements Command {}

  /**
   * Answers a question of a program. An answer of another kind is refused, and the question stays
   * open; a whole number answers a question for a number as well.
   */
  record AnswerQuestion(long number, Answer answer) implements Command {}

  /** Refuses to answer a question: the program stops (manual 18.73). */
  record CancelQuestion(long number) implements Command {}

  /**
   * Hands a line of statements to interpreter mode (manual 13).
   *
   * <p>While a line before it may still clear what was interpreted, it waits for its reply.
   */
  record Interpret(InterpretedLine line) implements Command {
    /**
     * Reads the line.
     *
     * @param line bytes, one {@code char} a byte, without the line end
     */
    public Interpret(String line) {
      this(InterpretedLine.read(line));
    }
  }

  /** Drops the interpreted lines that have not begun (manual 13.6). */
  record SkipInterpreted() implements Command {}

  /** Ends the move that the main thread waits for early (manual 13.5). */
  record AbortMove() implements Command {}

  /**
   * The computer could not keep up: robot time has fallen behind the wall clock.
   *
   * @param behindS by how much since the controller was switched on, s
   */
  record NoteLostTime(double behindS) implements Command {}

  /** Asks what interpreter mode is at; the answer is a {@link Reply.InterpreterState}. */
  record AskInterpreter() implements Command {}

  /** Switches arm and controller off; whoever drives the frames sees it in the snapshot. */
  record ShutDown() implements Command {}

  /**
   * Shows a window that holds up nothing, for somebody outside.
   *
   * @param title bytes, one {@code char} a byte
   * @param text bytes, one {@code char} a byte
   */
  record ShowPopup(String title, String text) implements Command {}

  /** Powers the arm on; it rests on its brakes then. */
  record PowerOn() implements Command {}

  /** Powers the arm off; a program ends. */
  record PowerOff() implements Command {}

  /** Releases the brakes of a powered arm; programs may start then. */
  record ReleaseBrakes() implements Command {}

  /**
   * Ends a protective stop; the program stays paused.
   *
   * @param early also within 5 s of the stop, the time that people have to look at what has
   *     happened
   */
  record UnlockProtectiveStop(boolean early) implements Command {}

  /**
   * Starts the safety functions again after a violation or a fault; the arm is powered off then.
   */
  record RestartSafety() implements Command {}

  /** Lets a powered arm be pushed about by hand. */
  record StartBackdrive() implements Command {}

  /** Locks the brakes again after {@link StartBackdrive}. */
  record EndBackdrive() implements Command {}

  /**
   * Chooses manual mode or leaves it: the safeguard stop of automatic mode does not count in it.
   */
  record SetManualMode(boolean manual) implements Command {}

  /** Demands a safety function, or no longer does. */
  record SetSafetyInput(SafetyInput input, boolean active) implements Command {}

  /**
   * Pushes the tool until told otherwise.
   *
   * @param wrenchAtTcpInBase force and torque at the TCP, along the axes of the base
   */
  record PushTool(Wrench wrenchAtTcpInBase) implements Command {}

  /**
   * Pushes the arm at a point of one of its links until told otherwise, besides {@link PushTool}. A
   * hand holds one place only: another push or pull takes the place of it.
   *
   * @param link the link that joint {@code link} (0 to 5) moves; 5 is the flange
   * @param pointInLinkM where, in the Denavit-Hartenberg frame behind that joint, -4 to 4 m each
   * @param forceInBaseN along the axes of the base, -10,000 to 10,000 N each; all 0 lets go
   */
  record PushLink(int link, Vector3 pointInLinkM, Vector3 forceInBaseN) implements Command {}

  /**
   * Pulls the arm at a point of one of its links towards a place, with at most {@link
   * HandGrip#MAX_PULL_N} and half of what the motors can give, as long as this is repeated: at the
   * latest every {@link HandGrip#DEAD_MAN_S} of robot time. The arm follows in freedrive; otherwise
   * it resists.
   *
   * @param link as in {@link PushLink}
   * @param pointInLinkM as in {@link PushLink}
   * @param placeInBaseM in the base frame, -100 to 100 m each
   */
  record PullLink(int link, Vector3 pointInLinkM, Vector3 placeInBaseM) implements Command {}

  /** Ends {@link PushLink} and {@link PullLink}. */
  record LetGo() implements Command {}

  /**
   * Lets the arm be guided by hand as long as this is repeated: at the latest every {@link
   * Jogging#DEAD_MAN_S} of robot time, or the arm holds where it is. Refused while a program runs
   * or is paused, while the arm is stopped or off, and when the declared payload is wrong; the
   * reply to a repetition tells why freedrive has ended.
   *
   * @param axes which axes are free
   * @param frame whose axes these are
   */
  record StartFreedrive(FreeAxes axes, FreedriveFrame frame) implements Command {}

  /** Ends {@link StartFreedrive}: the arm holds where it is. */
  record EndFreedrive() implements Command {}

  /**
   * Hangs something on the flange, whatever programs declare.
   *
   * @param load what it is; empty for what programs declare
   */
  record AttachLoad(Optional<Payload> load) implements Command {}

  /**
   * Moves the arm by hand as long as this is repeated: at the latest every {@link
   * Jogging#DEAD_MAN_S} of robot time, or the arm comes to rest on its path. Refused while a
   * program runs or is paused, and while the arm is stopped or off; the reply to a repetition tells
   * why the arm goes no further.
   *
   * @param speedFraction above 0 and at most 1: of 0.6 rad/s for the fastest joint, or of 0.25 m/s
   *     and 1 rad/s for the tool
   */
  record Jog(JogMove move, double speedFraction) implements Command {}

  /**
   * Asks something of the debugger, in the frame loop: sets breakpoints, steps, looks at variables
   * and changes them. Refused with the message when the request throws an {@link
   * IllegalArgumentException}; what it finds out it hands over itself, for instance through a
   * future.
   */
  record Debug(Consumer<Debugger> request) implements Command {}

  /**
   * Reads chosen variables of programs in every frame from now on, into {@link
   * org.pendant.controller.state.ControllerState#traced}. Refused if that were more than {@link
   * VariableTracer#MOST}, those of other owners included.
   *
   * @param owner who wants them, a name that nobody else uses; takes the place of its last wish
   * @param paths what it wants; empty for nothing any more
   */
  record TraceVariables(String owner, List<VariablePath> paths) implements Command {
    public TraceVariables {
      paths = List.copyOf(paths);
    }
  }

  /** Ends {@link Jog}: the arm comes to rest on its path. */
  record StopJog() implements Command {}

  /** Changes the active TCP; refused while the arm moves or a program runs or is paused. */
  record SetTool(ToolCentre tool) implements Command {}

  /**
   * Declares the payload; refused while the arm moves or a program runs or is paused. The force
   * sensor is zeroed.
   *
   * @param massKg 0 to four times what the arm is made for, kg
   * @param cogInFlangeM its centre of gravity in the flange frame, m
   * @param inertiaKgM2 about the centre of gravity, along the axes of the flange; empty for that of
   *     a point
   */
  record DeclarePayload(double massKg, Vector3 cogInFlangeM, Optional<Inertia> inertiaKgM2)
      implements Command {}

  /**
   * Writes a line to the log for somebody who speaks to the controller by a protocol.
   *
   * @param text bytes, one {@code char} a byte
   */
  record WriteLog(LogEntry.Level level, String text) implements Command {}
}
