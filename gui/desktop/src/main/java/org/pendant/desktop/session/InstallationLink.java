package org.pendant.desktop.session;

import static org.pendant.desktop.session.SessionTexts.text;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.Executor;
import java.util.function.Consumer;
import org.pendant.controller.InstallationCommand;
import org.pendant.controller.command.Reply;
import org.pendant.controller.installation.Installation;
import org.pendant.controller.installation.InstallationVariable;
import org.pendant.controller.installation.StartEdge;
import org.pendant.controller.state.ControllerState;
import org.pendant.script.vm.ProgramState;

/**
 * Installation link: keeps the session's controller set up as the desktop's installation says, and
 * takes over what programs leave in its variables and what clients load. While a program runs the
 * controller stays as it is; it follows when the program has ended.
 */
public final class InstallationLink implements FrameListener, SwitchListener {
  private final RobotSession session;
  private final ActiveInstallation active;
  private final Executor dispatch;
  private final Consumer<String> tell;
  private final Runnable startProgram;

  /** What the controller was told last. */
  private volatile Optional<Installation> sent = Optional.empty();

  /** The controller has not taken it yet. */
  private volatile boolean waiting;

  /** The dispatch thread has been asked to try again. */
  private volatile boolean busy;

  /** One controller is about to go, or another one has come: it may be either that there is. */
  private volatile boolean between;

  /** The controller is another one, for which nothing that was seen of the last one holds. */
  private volatile boolean switched;

  // of the thread that drives the frames
  private final StartEdge edge = new StartEdge();
  private Installation seen;

  /**
   * A link that works from now on; called in the dispatch thread.
   *
   * @param dispatch runs things in the dispatch thread
   * @param tell tells people why the controller cannot be set up yet
   * @param startProgram starts the program in front, as an input may ask for
   */
  public InstallationLink(
      RobotSession session,
      ActiveInstallation active,
      Executor dispatch,
      Consumer<String> tell,
      Runnable startProgram) {
    this.session = session;
    this.active = active;
    this.dispatch = dispatch;
    this.tell = tell;
    this.startProgram = startProgram;
    seen = session.robot().installation();
    active.begin(seen);
    active.addListener(this::send);
    session.addFrameListener(this);
    session.addSwitchListener(this);
  }

  private void send() {
    Installation wanted = active.current();
    waiting = false;
    active.setWaiting("");
    if (wanted.equals(session.robot().installation())) {
      return;
    }
    sent = Optional.of(wanted);
    var _ =
        session
            .submit(new InstallationCommand.ApplyInstallation(wanted))
            .thenAccept(reply -> dispatch.execute(() -> answered(wanted, reply)));
  }

  private void answered(Installation wanted, Reply reply) {
    Optional<String> refusal = reply.complaint();
    if (refusal.isPresent() && wanted.equals(active.current())) {
      tell.accept(text("theControllerIsNotSetUp", refusal.get()));
      active.setWaiting(refusal.get());
      waiting = true;
    }
  }

  @Override
  public void frame(ControllerState state) {
    if (between) {
      return;
    }
    Installation now = session.robot().installation();
    if (switched) {
      switched = false;
      seen = now;
    }
    follow(now);
    if (waiting
        && state.program().state() == ProgramState.STOPPED
        && !state.arm().moving()
        && !busy) {
      busy = true;
      dispatch.execute(this::tryAgain);
    }
    if (edge.look(now.startUp(), state.io())) {
      dispatch.execute(startProgram);
    }
  }

  private void tryAgain() {
    busy = false;
    send();
  }

  /** Takes over what others have changed: a program its variables, a client all of it. */
  @SuppressWarnings(
      "ReferenceEquality") // the controller keeps the very object while it is as it is
  private void follow(Installation now) {
    if (now == seen) {
      return;
    }
    Installation before = seen;
    seen = now;
    if (sent.isPresent() && sent.get() == now) {
      return;
    }
    if (now.withVariables(List.of()).equals(before.withVariables(List.of()))) {
      List<InstallationVariable> changed = new ArrayList<>(now.variables());
      changed.removeAll(before.variables());
      dispatch.execute(() -> take(changed));
    } else {
      dispatch.execute(() -> active.set(now));
    }
  }

  /** Takes over values that a program has left. */
  private void take(List<InstallationVariable> changed) {
    List<InstallationVariable> all = new ArrayList<>();
    for (InstallationVariable each : active.current().variables()) {
      String value =
          changed.stream()
              .filter(left -> left.name().equals(each.name()))
              .map(InstallationVariable::value)
              .findFirst()
              .orElse(each.value());
      all.add(new InstallationVariable(each.name(), value, each.favourite()));
    }
    active.set(active.current().withVariables(all));
  }

  @Override
  public void switchingOff() {
    between = true;
  }

  @Override
  public void switchedOn() {
    switched = true;
    between = false;
    dispatch.execute(this::send);
  }

  @Override
  public void leaving() {
    between = true;
  }

  /** It is set up as it is; who shows it shows its installation. */
  @Override
  public void shown() {
    sent = Optional.empty();
    switched = true;
    between = false;
  }
}
