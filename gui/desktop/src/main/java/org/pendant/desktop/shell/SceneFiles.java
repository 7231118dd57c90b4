package org.pendant.desktop.shell;

import static org.pendant.desktop.shell.ShellTexts.text;

import java.awt.Component;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.BiConsumer;
import java.util.function.Consumer;
import org.pendant.controller.world.MeshFiles;
import org.pendant.controller.world.MeshPart;
import org.pendant.controller.world.SceneWriter;
import org.pendant.desktop.help.ExampleMeshes;
import org.pendant.desktop.session.ActiveInstallation;
import org.pendant.desktop.session.DiskChange;
import org.pendant.desktop.session.ProgramDocument;
import org.pendant.desktop.session.SavedProgram;
import org.pendant.desktop.session.SceneDraft;
import org.pendant.desktop.session.SceneFile;
import org.pendant.desktop.session.SceneMemory;
import org.pendant.desktop.session.SceneMove;
import org.pendant.desktop.shell.Notices.Choice;
import org.pendant.kit.action.Action;
import org.pendant.kit.action.ActionTable;
import org.pendant.kit.background.Background;
import org.pendant.kit.export.SaveDialog;
import org.pendant.kit.export.SaveRequest;

/**
 * Scene files: puts scenes around the arm, remembers which belongs to which installation, and
 * notices when another program changes the file. One thread uses it, the dispatch thread.
 */
final class SceneFiles {
  private static final String TROUBLE = "scene-trouble";
  private static final String CHANGED = "scene-change";
  private static final String MESHES = "scene-meshes";

  private final ActiveInstallation installation;
  private final SceneDraft draft;
  private final DocumentSaver saver;
  private final SceneMemory memory;
  private final Notices notices;
  private final Consumer<String> tell;
  private final UsedFolder used;
  private final Component parent;
  private final UnsavedQuestion unsaved;
  private final BiConsumer<SceneFile, Runnable> surround;
  private ProgramDocument known;
  private Optional<Path> knownFile;
  private SceneFile current = SceneFile.NONE;

  /** The document of what is around the arm, which the draft may have left behind. */
  private ProgramDocument ofCurrent;

  /** The meshes that came with what is around the arm, where that has no file. */
  private ExampleMeshes lent = ExampleMeshes.NONE;

  private Optional<Path> wanted = Optional.empty();
  private DiskChange change = new DiskChange();
  private boolean looking;
  private Runnable show = () -> {};

  /**
   * Nothing is around the arm yet.
   *
   * @param draft what people change
   * @param surround puts a scene around the arm, perhaps after a question, and then runs what it is
   *     given
   * @param used where dialogs begin
   * @param parent dialogs belong to its window
   */
  SceneFiles(
      ActiveInstallation installation,
      SceneDraft draft,
      DocumentSaver saver,
      SceneMemory memory,
      Notices notices,
      Consumer<String> tell,
      UsedFolder used,
      Component parent,
      BiConsumer<SceneFile, Runnable> surround) {
    this.installation = installation;
    this.draft = draft;
    this.saver = saver;
    this.memory = memory;
    this.notices = notices;
    this.tell = tell;
    this.used = used;
    this.parent = parent;
    unsaved = new UnsavedQuestion(notices, "scene", draft::document, this::save);
    this.surround = surround;
    known = installation.document();
    knownFile = known.file();
    installation.addFileListener(this::followInstallation);
    ofCurrent = draft.document();
    draft.addListener(this::followDraft);
  }

  /** {@code how} shows the scene that people have made and are going to change. */
  void showBy(Runnable how) {
    show = how;
  }

  /** What can be done with them. */
  void addActions(ActionTable actions) {
    actions.add(Action.of("scene-file.open", text("openScene"), "", this::open));
    actions.add(
        new Action(
            "scene-file.reload",
            text("readTheSceneFromDiskAgain"),
            "",
            () -> current.path().or(() -> wanted).isPresent(),
            () -> current.path().or(() -> wanted).ifPresent(this::open)),
        () -> text("noSceneOfAFileIs"));
    actions.add(
        new Action(
            "scene-file.close",
            text("closeTheScene"),
            "",
            () -> !current.isNone() || wanted.isPresent(),
            this::close),
        () -> text("noSceneIsOpen"));
    actions.add(Action.of("scene-file.new", text("newScene"), "", this::create));
    actions.add(
        new Action(
            "scene-file.save",
            text("saveScene"),
            "",
            () -> draft.document().modified() || draft.document().file().isEmpty(),
            () -> save(saved -> {})),
        () -> text("nothingHasChanged"));
    actions.add(
        Action.of("scene-file.save-as", text("saveSceneAs"), "", () -> saveAs(saved -> {})));
    actions.add(
        new Action("scene-file.apply", text("applyTheScene"), "", this::canApply, this::apply),
        () -> text("thisSceneIsAroundTheArm"));
  }

  /** What is around the arm. */
  SceneFile current() {
    return current;
  }

  /** Takes over what the controller was switched on with. */
  void begin(StartScene start) {
    current = start.scene();
    followCurrent();
    wanted = start.wanted();
    if (!start.trouble().isEmpty()) {
      trouble(start.trouble(), wanted);
    }
  }

  /**
   * Scenes are remembered for an installation that is not open yet, as those of the arms of a cell
   * are in its place.
   */
  void belongTo(Path coming) {
    if (InstallationFiles.isOurs(coming)) {
      knownFile = Optional.of(coming);
    }
  }

  private void create() {
    unsaved.before(
        () -> {
          draft.open(SceneFile.NONE);
          show.run();
        });
  }

  /** Whether what people change is not around the arm. */
  boolean canApply() {
    return draft.document() != ofCurrent || !draft.document().text().equals(current.text());
  }

  /** Puts what people change around the arm. */
  private void apply() {
    ProgramDocument document = draft.document();
    SceneFile next;
    try {
      next =
          SceneFile.of(document.name(), document.text(), draft.meshes())
              .at(document.name(), document.onDisk());
    } catch (IOException e) {
      trouble(e.getMessage(), Optional.empty());
      return;
    }
    surround.accept(
        next,
        () -> {
          ofCurrent = document;
          current = next;
          remember(current.path());
          tell.accept(text("aroundTheArm", current.words()));
        });
  }

  /** The file of what is around the arm may be another one, or newer, after a save. */
  private void followDraft() {
    if (draft.document() == ofCurrent && !current.isNone()) {
      Optional<SavedProgram> onDisk = ofCurrent.onDisk();
      if (!onDisk.equals(current.onDisk())) {
        current = current.at(ofCurrent.name(), onDisk);
        change = new DiskChange();
        remember(current.path());
      }
    }
  }

  private void followCurrent() {
    draft.open(current);
    ofCurrent = draft.document();
  }

  /**
   * Saves what people change where it is, or asks where.
   *
   * @param then hears whether it is on disk now
   */
  void save(Consumer<Boolean> then) {
    if (draft.document().file().isEmpty()) {
      saveAs(then);
    } else {
      saver.save(draft.document(), then);
    }
  }

  private void saveAs(Consumer<Boolean> then) {
    ProgramDocument document = draft.document();
    Path here = document.file().orElse(Path.of(document.name()));
    SaveDialog.ask(
        parent,
        new SaveRequest(
            text("saveAs", document.name()),
            document.file().isPresent() ? here.toAbsolutePath() : used.get().resolve(here),
            List.of("json"),
            SceneFiles::fitting,
            List.of()),
        chosen -> chosen.ifPresentOrElse(path -> saveAs(path, then), () -> then.accept(false)));
  }

  /**
   * Saves what people change in a file that they have chosen, with the meshes that it names.
   *
   * @param then hears whether it is on disk now
   */
  void saveAs(Path path, Consumer<Boolean> then) {
    ProgramDocument document = draft.document();
    List<String> borrowed = document == ofCurrent ? borrowed(document) : List.of();
    if (!borrowed.isEmpty()) {
      copy(
          () -> new SceneMove(lent.unpack(), path.getParent()).copy(borrowed),
          () -> write(document, path, Optional.empty(), then),
          then);
      return;
    }
    Optional<SceneMove> move =
        document.file().map(file -> new SceneMove(file.getParent(), path.getParent()));
    List<String> copies =
        move.map(each -> each.toCopy(draft.scene(), draft.meshesOfArms())).orElseGet(List::of);
    if (copies.isEmpty()) {
      write(document, path, move, then);
      return;
    }
    notices.ask(
        MESHES,
        copies.size() == 1
            ? text("meshIsNotInTheNewFolder", copies.getFirst())
            : text("meshesAreNotInTheNewFolder", copies.size(), copies.getFirst()),
        List.of(
            new Choice(
                "copy-and-save",
                text("copyAndSave"),
                () ->
                    copy(
                        () -> move.get().copy(copies),
                        () -> write(document, path, move, then),
                        then)),
            new Choice("cancel", text("cancel"), () -> then.accept(false), true)));
    notices.focus();
  }

  /** Meshes that its scene names and that are in no folder of the user's. */
  private List<String> borrowed(ProgramDocument document) {
    return document.file().isPresent()
        ? List.of()
        : draft.scene().meshes().stream()
            .map(MeshPart::file)
            .distinct()
            .filter(lent.files()::contains)
            .toList();
  }

  /** Copies of meshes. */
  private interface Copying {
    void run() throws IOException;
  }

  private void copy(Copying meshes, Runnable copied, Consumer<Boolean> then) {
    Background.run(
        () -> {
          meshes.run();
          return true;
        },
        all -> copied.run(),
        failed -> {
          notices.tell(MESHES, text("theSceneIsNotSavedThere", failed.getMessage()));
          then.accept(false);
        });
  }

  private void write(
      ProgramDocument document, Path path, Optional<SceneMove> move, Consumer<Boolean> then) {
    SavedProgram as = document.toSaveAs(path);
    Optional<SceneMove> renaming =
        move.filter(each -> !each.renamed(draft.scene()).equals(draft.scene()));
    if (renaming.isEmpty()) {
      saver.saveAs(document, as, then);
      return;
    }
    String text = SceneWriter.write(renaming.get().renamed(draft.scene()), draft.equipment());
    saver.saveAs(
        document,
        new SavedProgram(as.path(), text, as.charset(), as.carriageReturns(), as.remarks()),
        saved -> {
          if (saved && document == draft.document()) {
            rename(renaming.get());
          }
          then.accept(saved);
        });
  }

  /** Has all that is known of the scene name its meshes from the new folder. */
  private void rename(SceneMove move) {
    boolean isCurrent = draft.document() == ofCurrent && draft.scene().equals(current.scene());
    draft.rename(move::renamed);
    if (isCurrent) {
      ProgramDocument document = draft.document();
      try {
        current =
            SceneFile.of(document.name(), document.text(), draft.meshes())
                .at(document.name(), document.onDisk());
      } catch (IOException e) {
        trouble(e.getMessage(), document.file());
      }
    }
  }

  /** A scene is known by the ending of its file. */
  private static Path fitting(Path path) {
    if (SceneFile.hasEnding(path)) {
      return path;
    }
    String name = String.valueOf(path.getFileName());
    String bare =
        name.endsWith(".json") ? name.substring(0, name.length() - ".json".length()) : name;
    return path.resolveSibling(bare + SceneFile.ENDING);
  }

  private void open() {
    OpenDialog.show(
        parent, text("openSceneTitle"), text("scenes"), new String[] {"json"}, used, this::open);
  }

  /** Puts the scene of a file around the arm. */
  void open(Path file) {
    unsaved.before(() -> read(file));
  }

  private void read(Path file) {
    Background.run(
        () -> SceneFile.read(file),
        this::take,
        failed -> trouble(failed.getMessage(), Optional.of(file)));
  }

  /**
   * Puts a scene around the arm that is no file of the user's.
   *
   * @param meshes that come with it, and go along when it is saved
   */
  void openCopy(String name, String text, ExampleMeshes meshes) {
    unsaved.before(
        () ->
            Background.run(
                () -> SceneFile.of(name, text, MeshFiles.in(meshes.unpack())),
                scene -> take(scene, meshes),
                failed -> trouble(failed.getMessage(), Optional.empty())));
  }

  private void close() {
    unsaved.before(() -> take(SceneFile.NONE));
  }

  private void take(SceneFile next) {
    take(next, ExampleMeshes.NONE);
  }

  private void take(SceneFile next, ExampleMeshes meshes) {
    notices.close(TROUBLE);
    notices.close(CHANGED);
    surround.accept(
        next,
        () -> {
          current = next;
          followCurrent();
          lent = meshes;
          change = new DiskChange();
          remember(next.path());
          tell.accept(
              next.isNone() ? text("nothingIsAroundTheArm") : text("aroundTheArm", next.words()));
        });
  }

  private void remember(Optional<Path> file) {
    wanted = file;
    memory.put(knownFile, file);
  }

  private void trouble(String why, Optional<Path> file) {
    List<Choice> choices = new ArrayList<>();
    file.ifPresent(
        path -> choices.add(new Choice("try-again", text("tryAgain"), () -> open(path))));
    choices.add(new Choice("open-another", text("openAnother"), this::open));
    choices.add(Choice.nothing("close", text("close")));
    notices.close(CHANGED);
    notices.ask(TROUBLE, text("theSceneCannotBeUsed", why), choices);
  }

  /** Another installation brings the scene that was there with it last. */
  private void followInstallation() {
    if (installation.ofArm()) {
      return;
    }
    ProgramDocument document = installation.document();
    Optional<Path> file = document.file();
    boolean saved = document.equals(known);
    if (saved && file.equals(knownFile)) {
      return;
    }
    known = document;
    knownFile = file;
    if (saved) {
      memory.put(file, wanted);
      return;
    }
    Optional<Path> last = memory.of(file);
    if (last.isEmpty() || last.equals(wanted.or(() -> Optional.of(Path.of(""))))) {
      return;
    }
    if (last.get().toString().isEmpty()) {
      close();
    } else {
      open(last.get());
    }
  }

  /** Looks whether the file has changed on disk; called every few seconds. */
  void look() {
    Optional<SavedProgram> onDisk = current.onDisk();
    if (looking || onDisk.isEmpty()) {
      return;
    }
    looking = true;
    SceneFile asked = current;
    DiskChange changeOfAsked = change;
    Background.run(
        () -> changeOfAsked.look(onDisk.get()),
        found -> {
          looking = false;
          found.filter(each -> current.equals(asked)).ifPresent(this::offer);
        },
        // It is read again when it changes again.
        failed -> looking = false);
  }

  /** Whether the disk is being looked at. */
  boolean looking() {
    return looking;
  }

  private void offer(SavedProgram now) {
    if (notices.shows(TROUBLE)) {
      // It offers to read the file again, too, and says what was wrong with it.
      return;
    }
    notices.ask(
        CHANGED,
        text("hasChangedOnDisk", current.name()),
        List.of(
            new Choice("read-it-again", text("readItAgain"), () -> open(now.path())),
            Choice.nothing("keep-this-one", text("keepThisOne"))));
  }
}
