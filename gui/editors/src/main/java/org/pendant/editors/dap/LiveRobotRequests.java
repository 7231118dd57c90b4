package org.pendant.editors.dap;

import static org.pendant.editors.dap.DebugAdapterTexts.text;

import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import org.eclipse.lsp4j.jsonrpc.services.JsonRequest;
import org.pendant.controller.io.IoCommand;
import org.pendant.controller.io.Signal;
import org.pendant.controller.io.SignalBank;
import org.pendant.controller.io.SignalWrite;
import org.pendant.controller.state.ControllerState;
import org.pendant.editors.dap.look.Branch;
import org.pendant.editors.dap.look.EndedView;
import org.pendant.editors.dap.look.PastView;
import org.pendant.editors.dap.look.RobotBranches;
import org.pendant.editors.dap.look.Shown;
import org.pendant.editors.dap.look.StandingProgram;
import org.pendant.recording.Recording;

/**
 * Live robot requests, which the protocol has no word for: the robot as it is or was, also while
 * its program runs.
 */
public final class LiveRobotRequests {
  /** Under this name signals are written: a program may run meanwhile. */
  private static final String WRITER = "debug adapter";

  private final DebugSession session;
  private final ExecutionRequests execution;

  LiveRobotRequests(DebugSession session, ExecutionRequests execution) {
    this.session = session;
    this.execution = execution;
  }

  /**
   * Asks for the robot.
   *
   * @param timeS robot time, s; absent for the moment that the client looks at
   */
  record TimeAsked(Double timeS) {}

  /** Something that the robot has, as people read it. */
  record Named(String name, String value) {}

  /**
   * The robot at a moment.
   *
   * @param state of the program now: {@code running}, {@code stopped}, or {@code past} while the
   *     client looks at an earlier moment of it
   * @param arm as {@code --robot} names it
   * @param timeS robot time of that moment, s
   * @param fromS where the recording begins, s
   * @param nowS robot time now, s
   * @param robot as the scope of that name
   * @param signals digital and analog ones
   */
  record RobotNow(
      String state,
      String arm,
      double timeS,
      double fromS,
      double nowS,
      List<Named> robot,
      List<Named> signals) {
    RobotNow {
      robot = List.copyOf(robot);
      signals = List.copyOf(signals);
    }
  }

  /** {@code pendant/robot}: the robot, also while its program runs. */
  @JsonRequest("pendant/robot")
  public CompletableFuture<RobotNow> robot(TimeAsked asked) {
    return session.thread().request(() -> now(Optional.ofNullable(asked).map(TimeAsked::timeS)));
  }

  private CompletableFuture<RobotNow> now(Optional<Double> timeS) {
    Debuggee debuggee = session.program();
    Recording recording = debuggee.run().recording();
    ControllerState now = debuggee.run().robot().state();
    Optional<StandingProgram> view = session.view();
    boolean past = view.filter(PastView.class::isInstance).isPresent();
    boolean ended = view.filter(EndedView.class::isInstance).isPresent();
    ControllerState shown =
        timeS.isPresent() ? recording.at(timeS.get()) : past || ended ? view.get().state() : now;
    String state = past ? "past" : view.isPresent() ? "stopped" : "running";
    return all(RobotBranches.robot(shown))
        .thenCombine(
            all(RobotBranches.signals(shown)),
            (robot, signals) ->
                new RobotNow(
                    state,
                    shown.arm().description().id(),
                    shown.timeS(),
                    recording.firstS(),
                    now.timeS(),
                    robot,
                    signals));
  }

  private CompletableFuture<List<Named>> all(Branch branch) {
    return branch.page(0, Branch.MOST).thenApply(parts -> parts.stream().map(this::named).toList());
  }

  private Named named(Shown shown) {
    return new Named(shown.name(), shown.value(session.form()::shown));
  }

  /** {@code pendant/goToTime}: looks at a time of the recording, while the program is stopped. */
  @JsonRequest("pendant/goToTime")
  public CompletableFuture<Void> goToTime(TimeAsked asked) {
    return session
        .thread()
        .request(
            () ->
                asked == null || asked.timeS() == null
                    ? Refusals.answer(text("timeMissing"))
                    : session.leadingAway(execution.toTime(asked.timeS())));
  }

  /**
   * Switches a signal.
   *
   * @param bank such as {@code digital_out}
   */
  record SignalAsked(String bank, int index, boolean on) {}

  /** {@code pendant/setSignal}: switches an input or an output, also while the program runs. */
  @JsonRequest("pendant/setSignal")
  public CompletableFuture<Void> setSignal(SignalAsked asked) {
    return session.thread().request(() -> switchSignal(asked));
  }

  private CompletableFuture<Void> switchSignal(SignalAsked asked) {
    Optional<SignalBank> bank =
        Arrays.stream(SignalBank.values())
            .filter(each -> asked != null && each.text().equals(asked.bank()))
            .findFirst();
    if (bank.isEmpty()) {
      return Refusals.answer(text("unknownBank"));
    }
    if (session.view().filter(view -> view instanceof PastView).isPresent()) {
      return Refusals.answer(PastView.unchangeable());
    }
    SignalWrite write = new SignalWrite.Digital(new Signal(bank.get(), asked.index()), asked.on());
    return session
        .program()
        .run()
        .robot()
        .submit(new IoCommand.WriteSignals(WRITER, List.of(write)))
        .thenAcceptAsync(
            reply -> {
              reply
                  .complaint()
                  .ifPresent(
                      why -> {
                        throw Refusals.of(why);
                      });
              session.tellChanged("variables");
            },
            session.thread());
  }
}
