package org.pendant.desktop.shell;

import java.awt.EventQueue;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Consumer;
import org.pendant.desktop.session.ActiveInstallation;
import org.pendant.desktop.session.ProgramDocument;
import org.pendant.desktop.session.Programs;
import org.pendant.desktop.session.RobotSession;
import org.pendant.desktop.session.SavedProgram;
import org.pendant.desktop.session.SessionMember;
import org.pendant.desktop.session.SwitchListener;
import org.pendant.project.installation.text.InstallationText;

/**
 * Arms of a cell in the window: which program and which installation belong to which controller.
 * The window shows those of the controller that people look at. One thread uses it, the dispatch
 * thread, but for what the session tells.
 */
final class CellArms implements SwitchListener {
  private final RobotSession session;
  private final Programs programs;
  private final ActiveInstallation installation;
  private final ProgramRunner runner;
  private final Consumer<String> showRobot;

  /** The programs of controllers, by their names. */
  private final Map<String, ProgramDocument> programOf = new HashMap<>();

  /** The installations of controllers, by their names; that of one that is alone has none. */
  private final Map<String, ProgramDocument> installationOf = new HashMap<>();

  /** The files that controllers run, by their names. */
  private Map<String, String> named = Map.of();

  /** What the cell that is being switched on begins with. */
  private volatile Optional<CellStart> coming = Optional.empty();

  /** What people have, while the controllers of a test are there. */
  private Optional<Kept> kept = Optional.empty();

  private Runnable alone = () -> {};
  private Consumer<ProgramDocument> showProgram = program -> {};
  private String showing;
  private String heldLast = "";
  private boolean choosing;

  /** What belongs to controllers that come back. */
  private record Kept(
      Map<String, ProgramDocument> programOf,
      Map<String, ProgramDocument> installationOf,
      Map<String, String> named,
      String showing,
      ProgramDocument installation,
      boolean inCell) {}

  /**
   * Follows a session from now on.
   *
   * @param showRobot told the id of the robot that is shown
   */
  CellArms(
      RobotSession session,
      Programs programs,
      ActiveInstallation installation,
      ProgramRunner runner,
      Consumer<String> showRobot) {
    this.session = session;
    this.programs = programs;
    this.installation = installation;
    this.runner = runner;
    this.showRobot = showRobot;
    showing = session.shown().name();
    installation.setOfArm(session.inCell());
    session.addSwitchListener(this);
    programs.addListener(this::chosen);
  }

  /** {@code how} shows the program in front when a cell brings programs of its own. */
  void showBy(Consumer<ProgramDocument> how) {
    showProgram = how;
  }

  /** The next cell that is switched on begins with this; any thread. */
  void expect(CellStart start) {
    coming = Optional.of(start);
  }

  /** A controller that is alone begins with what {@code installed} opens. */
  void whenAlone(Runnable installed) {
    alone = installed;
  }

  /** What the window was opened with. */
  void begin(CellStart start) {
    expect(start);
    exchanged();
  }

  @Override
  public void switchingOff() {}

  @Override
  public void switchedOn() {
    EventQueue.invokeLater(this::exchanged);
  }

  @Override
  public void shown() {
    if (EventQueue.isDispatchThread()) {
      show();
    } else {
      EventQueue.invokeLater(this::show);
    }
  }

  /** Other controllers have come: their installations first, before anybody sets them up anew. */
  private void exchanged() {
    if (session.lent()) {
      exchangedForOthers();
      return;
    }
    kept.ifPresent(this::takeBack);
    kept = Optional.empty();
    Optional<CellStart> start = coming;
    coming = Optional.empty();
    boolean wasInCell = installation.ofArm();
    if (!wasInCell && session.inCell()) {
      installationOf.put("", installation.document());
    } else if (wasInCell && !showing.isEmpty()) {
      installationOf.put(showing, installation.document());
    }
    if (start.isPresent() && session.inCell()) {
      installationOf.keySet().retainAll(List.of(""));
      start
          .get()
          .installations()
          .forEach((name, file) -> installationOf.put(name, ProgramDocument.of(file)));
      named = start.get().named();
      programOf.clear();
      choosing = true;
      start.get().programs().forEach(this::open);
      choosing = false;
      adopt();
    }
    installation.setOfArm(session.inCell());
    if (session.inCell()) {
      showing = "";
      show();
      if (start.filter(each -> !each.programs().isEmpty()).isPresent()) {
        showProgram.accept(programs.current());
      }
    } else if (wasInCell) {
      showing = "";
      programOf.clear();
      named = Map.of();
      Optional<ProgramDocument> before = Optional.ofNullable(installationOf.remove(""));
      installationOf.clear();
      before.ifPresent(installation::open);
      alone.run();
      alone = () -> {};
      showRobot.accept(session.options().robotId());
    }
  }

  /** The controllers of a test have come, for a while. */
  private void exchangedForOthers() {
    if (kept.isEmpty()) {
      kept =
          Optional.of(
              new Kept(
                  new HashMap<>(programOf),
                  new HashMap<>(installationOf),
                  named,
                  showing,
                  installation.document(),
                  installation.ofArm()));
    }
    programOf.clear();
    installationOf.clear();
    named = Map.of();
    showing = "";
    if (session.inCell()) {
      installation.setOfArm(true);
      show();
    }
  }

  private void takeBack(Kept own) {
    programOf.clear();
    programOf.putAll(own.programOf());
    installationOf.clear();
    installationOf.putAll(own.installationOf());
    named = own.named();
    showing = own.showing();
    installation.setOfArm(own.inCell());
    if (installation.document() != own.installation()) {
      installation.open(own.installation());
    }
    if (!session.inCell()) {
      showRobot.accept(session.options().robotId());
    }
  }

  private void open(String controller, SavedProgram file) {
    ProgramDocument document = programs.of(file.path()).orElseGet(() -> ProgramDocument.of(file));
    programOf.put(controller, document);
    programs.open(document);
  }

  /** Programs that people have open may be those that the scene names. */
  private void adopt() {
    named.forEach(
        (controller, file) ->
            programs.all().stream()
                .filter(each -> each.name().equals(file))
                .findFirst()
                .ifPresent(each -> programOf.putIfAbsent(controller, each)));
  }

  /** Another controller is shown: so are its installation and its program. */
  private void show() {
    SessionMember now = session.shown();
    if (now.name().equals(showing)) {
      return;
    }
    if (!showing.isEmpty()) {
      installationOf.put(showing, installation.document());
    }
    showing = now.name();
    installation.open(installationOf.computeIfAbsent(showing, name -> untitled(now)));
    choosing = true;
    Optional.ofNullable(programOf.get(showing)).ifPresent(programs::select);
    choosing = false;
    programOf.put(showing, programs.current());
    runner.shown();
    showRobot.accept(now.options().robotId());
  }

  private static ProgramDocument untitled(SessionMember of) {
    return ProgramDocument.untitled(
        of.name() + InstallationText.ENDING, InstallationText.write(of.robot().installation()));
  }

  /** A program that is another controller's leads to it; any other belongs to the one shown. */
  private void chosen() {
    programOf.values().removeIf(each -> !programs.all().contains(each));
    if (!session.inCell() || choosing) {
      return;
    }
    adopt();
    if (programs.current() == programOf.get(showing)) {
      return;
    }
    Optional<String> owner =
        programOf.entrySet().stream()
            .filter(each -> each.getValue() == programs.current())
            .map(Map.Entry::getKey)
            .filter(name -> session.members().stream().anyMatch(each -> each.name().equals(name)))
            .findFirst();
    if (owner.isPresent()) {
      session.show(owner.get());
    } else {
      programOf.put(showing, programs.current());
    }
  }

  /** The program of a controller; empty where it has none. */
  Optional<ProgramDocument> program(SessionMember member) {
    return Optional.ofNullable(programOf.get(member.name()));
  }

  /** A controller whose program is paused by the debugger comes to the front, once. */
  void refresh() {
    if (!session.inCell()) {
      return;
    }
    String held =
        session.members().stream()
            .filter(each -> each.state().debug().held())
            .map(SessionMember::name)
            .findFirst()
            .orElse("");
    if (!held.equals(heldLast)) {
      heldLast = held;
      if (!held.isEmpty()) {
        session.show(held);
      }
    }
  }
}
