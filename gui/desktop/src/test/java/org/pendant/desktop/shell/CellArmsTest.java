package org.pendant.desktop.shell;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotSame;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.EventQueue;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicBoolean;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.pendant.controller.Cell;
import org.pendant.controller.ControllerOptions;
import org.pendant.controller.builtin.StandardBuiltins;
import org.pendant.controller.installation.Installation;
import org.pendant.desktop.session.ActiveInstallation;
import org.pendant.desktop.session.CellSetup;
import org.pendant.desktop.session.ProgramDocument;
import org.pendant.desktop.session.Programs;
import org.pendant.desktop.session.RobotSession;
import org.pendant.desktop.session.SceneFile;
import org.pendant.desktop.session.SessionMember;
import org.pendant.desktop.session.SharedCell;
import org.pendant.kit.settings.MemorySettings;
import org.pendant.project.installation.text.InstallationText;
import org.pendant.script.vm.ProgramState;

@Timeout(value = 60, unit = TimeUnit.SECONDS)
final class CellArmsTest {
  @TempDir Path folder;

  private final ProgramDocument own = ProgramDocument.untitled("own.script", "sleep(1)\n");
  private final Programs programs = new Programs(own);
  private final ActiveInstallation installation = new ActiveInstallation();
  private final List<String> told = new ArrayList<>();
  private final List<String> shown = new ArrayList<>();
  private RobotSession session;
  private ProgramRunner runner;
  private CellArms arms;

  @BeforeEach
  void open() throws Exception {
    Files.writeString(folder.resolve("left.script"), "sleep(1000)\n");
    Files.writeString(folder.resolve("cell.script"), "sleep(1000)\n");
    Path scene = Files.writeString(folder.resolve("two.scene.json"), SharedCell.SCENE);
    session = RobotSession.start(ControllerOptions.headless());
    runner = new ProgramRunner(session, programs, told::add, (line, column) -> {});
    arms = new CellArms(session, programs, installation, runner, id -> {});
    arms.showBy(program -> shown.add(program.name()));
    CellStart start = CellStart.of(SceneFile.read(scene), new MemorySettings());
    arms.expect(start);
    session.restart(start.setup());
    dispatch(() -> {});
  }

  @AfterEach
  void close() {
    session.close();
  }

  private static void dispatch(Runnable work) throws Exception {
    EventQueue.invokeAndWait(work);
  }

  private SessionMember member(String name) {
    return session.members().stream().filter(each -> each.name().equals(name)).findAny().get();
  }

  @Test
  void theProgramsThatTheSceneNamesAreOpenAndThatOfTheFirstArmIsInFront() {
    assertEquals(
        List.of("own.script", "left.script", "cell.script"),
        programs.all().stream().map(ProgramDocument::name).toList());
    assertEquals("left.script", programs.current().name());
    assertEquals(List.of("left.script"), shown);
  }

  @Test
  void eachControllerKeepsItsOwnProgram() throws Exception {
    ProgramDocument left = programs.current();
    dispatch(() -> session.show("right"));
    ProgramDocument mine = ProgramDocument.untitled("right.script", "sleep(1)\n");
    dispatch(() -> programs.select(mine));
    assertEquals("right", session.shown().name());
    dispatch(() -> session.show("left"));
    assertSame(left, programs.current());
    dispatch(() -> session.show("right"));
    assertSame(mine, programs.current());
  }

  @Test
  void programsAndInstallationsComeBackAfterATestHadControllersOfItsOwn() throws Exception {
    ProgramDocument left = programs.current();
    ProgramDocument script = arms.program(member("cell")).orElseThrow();
    ProgramDocument written = installation.document();
    CellSetup setup = SharedCell.setup();
    session.lend(
        setup, new Cell(setup.plan(), setup.options(), StandardBuiltins.create()), state -> {});
    dispatch(() -> {});
    assertNotSame(written, installation.document());
    assertEquals(Optional.empty(), arms.program(member("cell")));
    ProgramDocument test = ProgramDocument.untitled("test.script", "sleep(1)\n");
    dispatch(() -> programs.open(test));
    session.restart(setup);
    dispatch(() -> {});
    assertSame(left, programs.current());
    assertSame(script, arms.program(member("cell")).orElseThrow());
    assertSame(written, installation.document());
  }

  @Test
  void aProgramOfAnotherControllerLeadsToIt() throws Exception {
    ProgramDocument script = arms.program(member("cell")).orElseThrow();
    dispatch(() -> programs.select(script));
    assertEquals("cell", session.shown().name());
  }

  @Test
  void eachArmKeepsItsOwnInstallationAndNoneIsThatOfTheOneAlone() throws Exception {
    ProgramDocument left = installation.document();
    dispatch(() -> session.show("right"));
    assertEquals("right" + InstallationText.ENDING, installation.document().name());
    dispatch(() -> session.show("left"));
    assertSame(left, installation.document());
    assertTrue(installation.ofArm());
    session.restart(session.aloneOptions());
    dispatch(() -> {});
    assertEquals(ActiveInstallation.UNTITLED, installation.document().name());
    assertEquals(Installation.NONE, installation.current());
  }

  @Test
  void allProgramsAreStartedTogether() throws Exception {
    dispatch(
        () ->
            runner.runTogether(
                List.of(
                    new ProgramRunner.Assigned(member("left"), arms.program(member("left")).get()),
                    new ProgramRunner.Assigned(
                        member("cell"), arms.program(member("cell")).get()))));
    while (member("left").state().program().state() != ProgramState.RUNNING
        || member("cell").state().program().state() != ProgramState.RUNNING) {
      dispatch(() -> {});
    }
    assertEquals(ProgramState.STOPPED, member("right").state().program().state());
    assertEquals("left.script", runner.program().orElseThrow().name());
    dispatch(() -> session.show("cell"));
    assertEquals("cell.script", runner.program().orElseThrow().name());
    assertEquals(List.of(), told);
  }

  @Test
  void nothingStartsWhereOneProgramDoesNotCompile() throws Exception {
    ProgramDocument wrong = ProgramDocument.untitled("wrong.script", "movej(\n");
    dispatch(
        () ->
            runner.runTogether(
                List.of(
                    new ProgramRunner.Assigned(member("left"), arms.program(member("left")).get()),
                    new ProgramRunner.Assigned(member("right"), wrong))));
    AtomicBoolean loading = new AtomicBoolean(true);
    while (loading.get()) {
      dispatch(() -> loading.set(runner.loading()));
    }
    assertTrue(told.getFirst().startsWith("wrong.script cannot run"), told::toString);
    assertEquals(ProgramState.STOPPED, member("left").state().program().state());
  }

  @Test
  void theProgramsOfASceneThatIsNoFileAreThoseOfTheirNamesThatPeopleOpen() throws Exception {
    CellStart start =
        CellStart.of(SceneFile.of("copy.scene.json", SharedCell.SCENE), new MemorySettings());
    dispatch(() -> programs.select(own));
    dispatch(
        () ->
            programs.all().stream()
                .filter(each -> each != own)
                .forEach(each -> programs.close(each, own)));
    arms.expect(start);
    session.restart(start.setup());
    dispatch(() -> {});
    assertEquals(Optional.empty(), arms.program(member("cell")));
    ProgramDocument opened = ProgramDocument.untitled("cell.script", "sleep(1)\n");
    dispatch(() -> programs.open(opened));
    assertSame(opened, arms.program(member("cell")).orElseThrow());
    assertEquals("left", session.shown().name());
  }
}
