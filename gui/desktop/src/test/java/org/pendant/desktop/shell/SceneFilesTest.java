package org.pendant.desktop.shell;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Component;
import java.awt.Container;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.TimeUnit;
import javax.swing.JButton;
import javax.swing.JPanel;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.pendant.controller.world.Scene;
import org.pendant.controller.world.SceneObject;
import org.pendant.desktop.help.Example;
import org.pendant.desktop.help.ExampleMeshes;
import org.pendant.desktop.session.ActiveInstallation;
import org.pendant.desktop.session.ProgramDocument;
import org.pendant.desktop.session.SavedProgram;
import org.pendant.desktop.session.SceneDraft;
import org.pendant.desktop.session.SceneFile;
import org.pendant.desktop.session.SceneMemory;
import org.pendant.kit.action.ActionTable;
import org.pendant.kit.settings.MemorySettings;
import org.pendant.kit.settings.Settings;
import org.pendant.models.dynamics.Payload;

@Timeout(value = 60, unit = TimeUnit.SECONDS)
final class SceneFilesTest {
  private static final String BALL =
      "{\"objects\": [{\"type\": \"sphere\", \"name\": \"%s\", \"centre\": [0.5, 0, 0.1],"
          + " \"radius\": 0.1}]}";

  @TempDir Path folder;

  private final ActiveInstallation installation = new ActiveInstallation();
  private final SceneDraft draft = new SceneDraft();
  private final Notices notices = new Notices();
  private final List<String> told = new ArrayList<>();
  private final List<Scene> surroundings = new ArrayList<>();
  private final Settings settings = new MemorySettings();
  private SceneFiles scenes;
  private Path file;

  /** Settings in memory. */
  @BeforeEach
  void begin() throws Exception {
    file = scene("a");
    DispatchThread.run(
        () ->
            scenes =
                new SceneFiles(
                    installation,
                    draft,
                    new DocumentSaver(new SaveQueue(), notices, told::add, told::add),
                    new SceneMemory(settings),
                    notices,
                    told::add,
                    new UsedFolder(folder, folder),
                    new JPanel(),
                    (scene, then) -> {
                      surroundings.add(scene.scene());
                      then.run();
                    }));
  }

  private Path scene(String name) throws IOException {
    return Files.writeString(folder.resolve(name + ".scene.json"), BALL.formatted(name));
  }

  private ProgramDocument installed(String name) throws IOException {
    Path path = folder.resolve(name);
    Files.writeString(path, "pendant installation 1\n");
    return ProgramDocument.of(SavedProgram.read(path));
  }

  private void open(Path opened) throws Exception {
    int before = told.size();
    DispatchThread.run(() -> scenes.open(opened));
    DispatchThread.await(() -> told.size() > before);
  }

  private Optional<Path> remembered(Optional<Path> of) {
    return new SceneMemory(settings).of(of);
  }

  @Test
  void aSceneThatIsOpenedIsPutAroundTheArmAndRemembered() throws Exception {
    open(file);

    assertEquals("a", surroundings.getLast().objects().getFirst().name());
    assertEquals(List.of("Around the arm: a.scene.json, 1 object"), told);
    assertEquals(Optional.of(file), remembered(Optional.empty()));
  }

  @Test
  void aFileThatIsNoSceneIsToldAndTheOldOneStays() throws Exception {
    open(file);
    Path wrong = Files.writeString(folder.resolve("b.scene.json"), "{\"object\": []}");

    DispatchThread.run(() -> scenes.open(wrong));
    DispatchThread.await(() -> notices.shows("scene-trouble"));

    assertEquals(Optional.of(file), scenes.current().path());
    assertEquals(1, surroundings.size());
    assertEquals(Optional.of(file), remembered(Optional.empty()));
  }

  @Test
  void aSceneOfLastTimeThatIsMissingIsToldAndNotForgotten() throws Exception {
    Path gone = folder.resolve("gone.scene.json");
    new SceneMemory(settings).put(Optional.empty(), Optional.of(gone));

    DispatchThread.run(() -> scenes.begin(StartScene.of(remembered(Optional.empty()))));

    assertTrue(notices.shows("scene-trouble"));
    assertEquals(Optional.of(gone), remembered(Optional.empty()));
  }

  @Test
  void aCellThatIsLeftDoesNotComeBackWithTheInstallationOfItsStart() throws Exception {
    ActionTable actions = new ActionTable(settings);
    ProgramDocument alone = installed("alone.pinst");
    Optional<Path> path = alone.file();
    new SceneMemory(settings).put(path, Optional.of(file));
    DispatchThread.run(
        () -> {
          scenes.addActions(actions);
          installation.setOfArm(true);
          scenes.begin(StartScene.of(Optional.of(file)));
          scenes.belongTo(path.get());
          actions.run("scene-file.close");
          installation.setOfArm(false);
          installation.open(alone);
        });

    assertTrue(scenes.current().isNone());
    assertEquals(Optional.of(Path.of("")), remembered(path));
  }

  @Test
  void devicesThatAreWishedForAreAChangeOfTheSceneThatIsNotSaved() throws Exception {
    StartScene start = StartScene.of(Optional.of(file), List.of("two-finger"));
    DispatchThread.run(() -> scenes.begin(start));

    assertEquals("two-finger", scenes.current().equipment().devices().getFirst().name());
    assertTrue(draft.document().modified());
    assertFalse(scenes.canApply());
    assertEquals(start, StartScene.of(Optional.of(file), List.of("two-finger")));
    DispatchThread.run(draft::undo);
    assertFalse(draft.document().modified());
    assertTrue(scenes.canApply());
  }

  @Test
  void devicesWithoutASceneMakeOne() {
    StartScene start = StartScene.of(Optional.empty(), List.of("rg", "2fg"));
    assertEquals("untitled.scene.json, 0 objects, 2 devices", start.scene().words());
    assertEquals("", start.trouble());
  }

  @Test
  void anotherInstallationBringsTheSceneThatWasThereWithIt() throws Exception {
    ProgramDocument cell = installed("cell.pinst");
    DispatchThread.run(() -> installation.open(cell));
    open(file);
    ProgramDocument other = installed("other.pinst");
    DispatchThread.run(() -> installation.open(other));
    assertEquals(Optional.of(file), scenes.current().path());
    open(scene("b"));

    DispatchThread.run(() -> installation.open(cell));

    DispatchThread.await(() -> scenes.current().path().equals(Optional.of(file)));
  }

  @Test
  void aFileThatChangesOnDiskIsOfferedAndNotTakenByItself() throws Exception {
    open(file);
    Files.writeString(file, BALL.formatted("changed"));

    DispatchThread.await(
        () -> {
          scenes.look();
          return notices.shows("scene-change");
        });

    assertEquals(1, surroundings.size());
    open(file);
    assertEquals("changed", surroundings.getLast().objects().getFirst().name());
  }

  @Test
  void whatIsWrongWithAChangedFileStaysToBeRead() throws Exception {
    open(file);
    Files.writeString(file, "{}}");
    DispatchThread.run(() -> scenes.open(file));
    DispatchThread.await(() -> notices.shows("scene-trouble"));

    DispatchThread.run(scenes::look);
    DispatchThread.await(() -> !scenes.looking());

    assertTrue(notices.shows("scene-trouble"));
    assertFalse(notices.shows("scene-change"));
  }

  @Test
  void aSceneThatPeopleHaveChangedIsAroundTheArmWhenItIsApplied() throws Exception {
    ActionTable actions = new ActionTable(settings);
    DispatchThread.run(
        () -> {
          scenes.addActions(actions);
          assertFalse(scenes.canApply());
          draft.set(new Scene(List.of(), Optional.of(Payload.of(2, 0, 0, 0)), List.of()));
          assertTrue(scenes.canApply());
          actions.run("scene-file.apply");
          assertEquals(List.of(draft.scene()), surroundings);
          assertFalse(scenes.canApply());
          assertEquals("Around the arm: untitled.scene.json, 0 objects and a load", told.getLast());
        });
  }

  @Test
  void aNewSceneIsShownWhereItIsChanged() throws Exception {
    ActionTable actions = new ActionTable(settings);
    DispatchThread.run(
        () -> {
          scenes.addActions(actions);
          scenes.showBy(() -> told.add("shown"));
          actions.run("scene-file.new");
          assertEquals(List.of("shown"), told);
        });
  }

  @Test
  void whatIsNotSavedIsAskedAboutBeforeAnotherSceneIsRead() throws Exception {
    DispatchThread.run(
        () -> {
          draft.set(new Scene(List.of(), Optional.of(Payload.of(2, 0, 0, 0)), List.of()));
          scenes.open(file);
          assertTrue(notices.shows("scene-unsaved"));
          assertEquals(List.of(), surroundings);
        });
  }

  @Test
  void aSavedSceneIsNotTakenForOneThatOthersHaveChanged() throws Exception {
    DispatchThread.run(() -> scenes.open(file));
    DispatchThread.await(() -> !draft.scene().equals(Scene.EMPTY));
    DispatchThread.run(
        () -> {
          draft.set(new Scene(List.of(), Optional.empty(), List.of()));
          scenes.save(told -> {});
        });
    DispatchThread.await(() -> !draft.document().modified());
    assertEquals("{}\n", Files.readString(file));
    DispatchThread.run(scenes::look);
    DispatchThread.await(() -> !scenes.looking());
    DispatchThread.run(() -> assertFalse(notices.shows("scene-change")));
  }

  /** A scene with a mesh in a folder below its own. */
  private Path sceneWithMesh() throws IOException {
    Path cell = Files.createDirectories(folder.resolve("cell/parts")).getParent();
    Files.writeString(
        cell.resolve("parts/a.obj"),
        "v 0 0 0\nv 60 0 0\nv 60 40 0\nv 0 40 0\nv 30 20 20\n"
            + "f 4 3 2 1\nf 1 2 5\nf 2 3 5\nf 3 4 5\nf 4 1 5\n");
    return Files.writeString(
        cell.resolve("m.scene.json"),
        "{\"objects\": [{\"type\": \"mesh\", \"name\": \"a\", \"pose\": [0, 0, 0, 0, 0, 0],"
            + " \"mesh\": \"parts/a.obj\", \"unit\": \"mm\"}]}");
  }

  private void saveAs(Path path) throws Exception {
    DispatchThread.run(() -> scenes.saveAs(path, saved -> told.add("saved " + saved)));
  }

  private void press(String name) throws Exception {
    DispatchThread.run(
        () -> {
          for (JButton button : buttons(notices)) {
            if (name.equals(button.getName())) {
              button.doClick(0);
              return;
            }
          }
          throw new AssertionError("there is no " + name);
        });
  }

  private static List<JButton> buttons(Container in) {
    List<JButton> found = new ArrayList<>();
    for (Component each : in.getComponents()) {
      if (each instanceof JButton button) {
        found.add(button);
      } else if (each instanceof Container container) {
        found.addAll(buttons(container));
      }
    }
    return found;
  }

  @Test
  void aSceneThatIsSavedAboveItsMeshesNamesThemFromThere() throws Exception {
    open(sceneWithMesh());
    Path above = folder.resolve("m.scene.json");
    saveAs(above);
    DispatchThread.await(() -> told.contains("saved true"));

    assertEquals(
        "cell/parts/a.obj",
        ((SceneObject.Mesh) SceneFile.read(above).scene().objects().getFirst()).part().file());
    assertFalse(draft.document().modified());
    assertFalse(scenes.canApply(), "what is around the arm is the same");
    assertEquals(Optional.of(above), scenes.current().path());
  }

  @Test
  void meshesAreCopiedToAnotherFolderAfterAQuestion() throws Exception {
    open(sceneWithMesh());
    Path other = Files.createDirectory(folder.resolve("other")).resolve("m.scene.json");
    saveAs(other);
    assertTrue(notices.shows("scene-meshes"));
    press("scene-meshes-cancel");
    DispatchThread.await(() -> told.contains("saved false"));
    assertFalse(Files.exists(other));

    saveAs(other);
    press("scene-meshes-copy-and-save");
    DispatchThread.await(() -> told.contains("saved true"));
    assertEquals(1, SceneFile.read(other).scene().objects().size());
    assertFalse(draft.document().modified());
  }

  @Test
  void meshesOfAnExampleAreAroundTheArmAndGoAlongWhenItIsSaved() throws Exception {
    String name = "lift_casting.scene.json";
    ExampleMeshes meshes = new ExampleMeshes(List.of("parts/casting.stl"));
    DispatchThread.run(() -> scenes.openCopy(name, Example.companion(name), meshes));
    DispatchThread.await(() -> !told.isEmpty());
    assertEquals(1, surroundings.getLast().meshes().size());
    Path mine = Files.createDirectory(folder.resolve("mine")).resolve("mine.scene.json");
    saveAs(mine);
    DispatchThread.await(() -> told.contains("saved true"));

    assertEquals(draft.scene(), SceneFile.read(mine).scene());
    assertTrue(Files.exists(mine.resolveSibling("parts/casting.stl")));
  }

  @Test
  void aFileThatIsInTheWayOfAMeshIsToldAndNothingIsSaved() throws Exception {
    open(sceneWithMesh());
    Path parts = Files.createDirectories(folder.resolve("other/parts"));
    Files.writeString(parts.resolve("a.obj"), "mine");
    Path other = parts.resolveSibling("m.scene.json");
    saveAs(other);
    press("scene-meshes-copy-and-save");
    DispatchThread.await(() -> told.contains("saved false"));

    assertTrue(notices.shows("scene-meshes"));
    assertFalse(Files.exists(other));
    assertEquals("mine", Files.readString(parts.resolve("a.obj")));
  }
}
