package org.pendant.desktop.installation;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.function.Consumer;
import java.util.function.Supplier;
import org.pendant.controller.installation.Installation;
import org.pendant.controller.installation.InstallationCheck;
import org.pendant.controller.installation.InstallationParts;
import org.pendant.controller.installation.InstallationProblem;
import org.pendant.controller.safety.FittedSafety;
import org.pendant.controller.safety.SafetyConfiguration;
import org.pendant.desktop.session.ActiveInstallation;
import org.pendant.desktop.session.ProgramDocument;
import org.pendant.kit.form.Measures;
import org.pendant.kit.text.Messages;
import org.pendant.models.arm.ArmDescription;

/**
 * Installation editing: changes the installation, checks changes before they are made, and undoes
 * them.
 */
final class Editing {
  private static final int MAX_UNDONE = 1000;

  private final ActiveInstallation active;
  private final Supplier<ArmDescription> arm;
  private final Measures measures;
  private final Deque<Installation> done = new ArrayDeque<>();
  private final Deque<Installation> undone = new ArrayDeque<>();
  private Installation known;
  private ProgramDocument document;
  private boolean turning;

  /**
   * Nothing to undo yet.
   *
   * @param arm that the installation has to fit
   */
  Editing(ActiveInstallation active, Supplier<ArmDescription> arm) {
    this(active, arm, Measures.USUAL);
  }

  /** As above, with numbers shown in {@code measures}. */
  Editing(ActiveInstallation active, Supplier<ArmDescription> arm, Measures measures) {
    this.active = active;
    this.arm = arm;
    this.measures = measures;
    known = active.current();
    document = active.document();
    active.addListener(this::follow);
    active.addFileListener(this::follow);
  }

  /** Changes by others are steps as well; another file begins anew. */
  private void follow() {
    if (active.document() != document) {
      document = active.document();
      done.clear();
      undone.clear();
    } else if (!turning && !active.current().equals(known)) {
      done.push(known);
      undone.clear();
      if (done.size() > MAX_UNDONE) {
        done.removeLast();
      }
    }
    known = active.current();
  }

  /** In what numbers are shown and typed. */
  Measures measures() {
    return measures;
  }

  /** What is set up. */
  Installation now() {
    return active.current();
  }

  /** The arm that it is for now. */
  ArmDescription arm() {
    return arm.get();
  }

  /** What holds where an installation is set up, as the arm can have it. */
  SafetyConfiguration safety(Installation of) {
    return of.safety()
        .map(each -> FittedSafety.of(each, arm()).configuration())
        .orElseGet(() -> SafetyConfiguration.standard(arm()));
  }

  /** What would be set up after a change. */
  Installation with(Consumer<InstallationParts> change) {
    return now().with(change);
  }

  /** Why a change cannot be made: what it would newly make wrong; empty if it can. */
  String refusal(Consumer<InstallationParts> change) {
    return whole(with(change));
  }

  /** As {@link #refusal}, for another installation in place of this one. */
  String whole(Installation next) {
    if (next.equals(now())) {
      return "";
    }
    Set<String> before = new HashSet<>();
    InstallationCheck.problems(now(), arm()).forEach(each -> before.add(each.message()));
    return InstallationCheck.problems(next, arm()).stream()
        // a limit that the arm cannot have would not hold as it was typed
        .filter(
            each -> each.blocks() || SignalNames.isName(each) || each.field().startsWith("safety."))
        .map(InstallationProblem::message)
        .filter(each -> !before.contains(each))
        .findFirst()
        .map(Messages::shown)
        .orElse("");
  }

  /** Makes a change that {@link #refusal} does not refuse. */
  void take(Consumer<InstallationParts> change) {
    active.set(with(change));
  }

  /** As {@link #take}, for another installation in place of this one. */
  void takeWhole(Installation next) {
    active.set(next);
  }

  /** What is not finished or wrong about something, such as {@code features[2].}. */
  Optional<String> problem(String field) {
    return InstallationCheck.problems(now(), arm()).stream()
        .filter(each -> each.field().startsWith(field))
        .map(each -> Messages.shown(each.message()))
        .findFirst();
  }

  boolean canUndo() {
    return !done.isEmpty();
  }

  boolean canRedo() {
    return !undone.isEmpty();
  }

  /** What {@link #undo} changes of the safety configuration, a line each: the arm loses power. */
  List<String> undoneSafety() {
    return safetyChanges(done);
  }

  /** As {@link #undoneSafety}, of {@link #redo}. */
  List<String> redoneSafety() {
    return safetyChanges(undone);
  }

  private List<String> safetyChanges(Deque<Installation> to) {
    return to.isEmpty() ? List.of() : SafetyChanges.of(safety(now()), safety(to.peek()), measures);
  }

  void undo() {
    turn(done, undone);
  }

  void redo() {
    turn(undone, done);
  }

  private void turn(Deque<Installation> from, Deque<Installation> to) {
    if (!from.isEmpty()) {
      to.push(active.current());
      turning = true;
      active.set(from.pop());
      turning = false;
    }
  }
}
