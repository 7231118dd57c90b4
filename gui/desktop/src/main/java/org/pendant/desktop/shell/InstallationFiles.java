package org.pendant.desktop.shell;

import static org.pendant.desktop.shell.ShellTexts.text;

import java.awt.Component;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.Set;
import java.util.function.Consumer;
import java.util.function.Supplier;
import org.pendant.command.service.StartInstallation;
import org.pendant.controller.disk.FileTrouble;
import org.pendant.controller.installation.Installation;
import org.pendant.desktop.session.ActiveInstallation;
import org.pendant.desktop.session.ProgramDocument;
import org.pendant.desktop.session.Programs;
import org.pendant.desktop.session.SavedProgram;
import org.pendant.desktop.shell.Notices.Choice;
import org.pendant.kit.action.Action;
import org.pendant.kit.action.ActionTable;
import org.pendant.kit.background.Background;
import org.pendant.kit.export.SaveDialog;
import org.pendant.kit.export.SaveRequest;
import org.pendant.kit.settings.Settings;
import org.pendant.kit.text.Messages;
import org.pendant.project.installation.file.InstallationFile;
import org.pendant.project.installation.file.InstallationTrouble;
import org.pendant.project.installation.file.LoadedInstallation;
import org.pendant.project.installation.text.InstallationText;
import org.pendant.project.program.text.ProgramText;

/**
 * Installation files: opens and saves the installation; what touches the disk is done elsewhere.
 */
final class InstallationFiles {
  private static final String RECENT = "installation.recent";
  private static final String OPEN = "installation.open";
  private static final String BESIDE = "installation-beside";
  private static final int MAX_RECENT = 10;
  private static final int SHOWN_REMARKS = 3;

  private final ActiveInstallation active;
  private final DocumentSaver saver;
  private final Settings settings;
  private final Notices notices;
  private final Consumer<String> tell;
  private final Consumer<String> warn;
  private final UsedFolder used;
  private final Component parent;
  private final UnsavedQuestion unsaved;

  /** Open programs whose people want the installation that there is. */
  private final Set<ProgramDocument> kept = new HashSet<>();

  /** The program in front; none before {@link #offerBeside}. */
  private Supplier<Optional<ProgramDocument>> inFront = Optional::empty;

  /** The installation that was offered last. */
  private Optional<Path> offered = Optional.empty();

  /**
   * Files of {@code active}.
   *
   * @param tell tells what was done
   * @param warn tells what was not done, so that it cannot be overlooked
   * @param used where dialogs begin
   * @param parent dialogs belong to its window
   */
  InstallationFiles(
      ActiveInstallation active,
      DocumentSaver saver,
      Settings settings,
      Notices notices,
      Consumer<String> tell,
      Consumer<String> warn,
      UsedFolder used,
      Component parent) {
    this.active = active;
    this.saver = saver;
    this.settings = settings;
    this.notices = notices;
    this.tell = tell;
    this.warn = warn;
    this.used = used;
    this.parent = parent;
    unsaved = new UnsavedQuestion(notices, "installation", active::document, this::save);
    active.addFileListener(this::rememberOpen);
  }

  /** Offers the installation that a program tree names, when it stands beside that. */
  void offerBeside(Programs programs) {
    inFront = () -> Optional.of(programs.current());
    programs.addListener(() -> offerFor(programs));
    active.addFileListener(this::withdraw);
    offerFor(programs);
  }

  private void offerFor(Programs programs) {
    ProgramDocument program = programs.current();
    notices.close(BESIDE);
    kept.retainAll(programs.all());
    Optional<Path> folder = program.file().map(Path::toAbsolutePath).map(Path::getParent);
    if (!program.isTree() || folder.isEmpty() || kept.contains(program)) {
      return;
    }
    String text = program.text();
    Background.run(
        () -> beside(folder.get(), ProgramText.read(text).tree().installation()),
        found ->
            found
                // It may have been read for long: another program is in front by now.
                .filter(file -> programs.current() == program && !isActive(file))
                .ifPresent(file -> offer(program, file)),
        this::notOpened);
  }

  /** Takes the offer back once that installation is open, by whatever way. */
  private void withdraw() {
    if (offered.filter(this::isActive).isPresent()) {
      notices.close(BESIDE);
    }
  }

  private static Optional<Path> beside(Path folder, String name) {
    try {
      return name.isEmpty()
          ? Optional.empty()
          : InstallationFile.namesOf(name).stream()
              .map(folder::resolve)
              .filter(Files::isRegularFile)
              .findFirst();
    } catch (InvalidPathException e) {
      // Nothing on this machine can have that name.
      return Optional.empty();
    }
  }

  private boolean isActive(Path file) {
    return active
        .document()
        .file()
        .filter(path -> path.toAbsolutePath().normalize().equals(file.normalize()))
        .isPresent();
  }

  private void offer(ProgramDocument program, Path file) {
    offered = Optional.of(file);
    notices.ask(
        BESIDE,
        text("isMadeForTheInstallationBeside", program.name(), file.getFileName()),
        List.of(
            new Choice("open-it", text("openIt"), () -> open(file)),
            new Choice("keep-this-one", text("keepThisOne"), () -> kept.add(program), true)));
  }

  /** What can be done with them. */
  void addActions(ActionTable actions) {
    actions.add(Action.of("installation.new", text("newInstallation"), "", this::create));
    actions.add(Action.of("installation.open", text("openInstallation"), "", this::open));
    actions.add(
        new Action(
            "installation.save",
            text("saveInstallation"),
            "",
            () -> active.document().modified() || active.document().file().isEmpty(),
            () -> save(saved -> {})),
        () -> text("nothingHasChanged"));
    actions.add(
        Action.of(
            "installation.save-as",
            text("saveInstallationAs"),
            "",
            () -> saveAs(active.document(), saved -> {})));
    actions.add(
        new Action(
            "installation.reload",
            text("readInstallationFromDiskAgain"),
            "",
            () -> active.document().file().isPresent(),
            this::reload),
        () -> text("theInstallationWasNeverSaved"));
  }

  private void create() {
    unsaved.before(
        () ->
            active.open(
                ProgramDocument.untitled(
                    ActiveInstallation.UNTITLED, InstallationText.write(Installation.NONE))));
  }

  private void open() {
    OpenDialog.show(
        parent,
        text("openInstallationTitle"),
        text("installations"),
        new String[] {"pinst", "installation"},
        folder(),
        used,
        this::open);
  }

  /** Where people look for installations: beside the present one, the program, or the last one. */
  Path folder() {
    return used.beside(
        List.of(
            active.document().file(),
            inFront.get().flatMap(ProgramDocument::file),
            recent().stream().findFirst()));
  }

  /** Opens a text that is no file of the user's, after asking for what is not saved. */
  void openCopy(String name, String text) {
    unsaved.before(() -> active.open(ProgramDocument.untitled(name, text)));
  }

  /** Opens a file in place of the present one, after asking for what is not saved. */
  void open(Path file) {
    unsaved.before(() -> read(file));
  }

  private void read(Path file) {
    if (isOurs(file)) {
      Background.run(() -> SavedProgram.read(file), this::opened, this::notOpened);
    } else {
      Background.run(() -> load(file), read -> imported(file, read), this::notOpened);
    }
  }

  /** Whether it is a file in which installations are saved; others are only read. */
  static boolean isOurs(Path file) {
    return file.toString().toLowerCase(Locale.ROOT).endsWith(InstallationText.ENDING);
  }

  private void opened(SavedProgram read) {
    ProgramDocument document = ProgramDocument.of(read);
    ActiveInstallation trial = new ActiveInstallation();
    trial.open(document);
    if (!trial.problem().isEmpty()) {
      warn.accept(text("notOpened", trial.problem()));
      return;
    }
    active.open(ProgramDocument.of(read));
    remember(read.path());
    tell.accept(text("openedTheInstallation", read.path().toAbsolutePath()));
  }

  private void imported(Path file, LoadedInstallation read) {
    active.open(untitledOf(file, read.installation()));
    tell.accept(text("openedACopyOfAnInstallation", file));
    List<String> remarks = read.remarks();
    remarks.stream()
        .limit(SHOWN_REMARKS)
        .forEach(each -> warn.accept(Messages.told(String.valueOf(file.getFileName()), each)));
    if (remarks.size() > SHOWN_REMARKS) {
      tell.accept(text("moreRemarksNotShown", file.getFileName(), remarks.size() - SHOWN_REMARKS));
    }
  }

  /** The file itself stays as it is. */
  private static ProgramDocument untitledOf(Path file, Installation installation) {
    String name = file.getFileName().toString();
    int end = name.lastIndexOf('.');
    ProgramDocument fresh =
        ProgramDocument.untitled(
            (end > 0 ? name.substring(0, end) : name) + InstallationText.ENDING,
            InstallationText.write(installation));
    fresh.gone();
    return fresh;
  }

  private void notOpened(IOException failed) {
    warn.accept(text("notOpened", failed.getMessage()));
  }

  /**
   * Reads an installation of any form; not for the dispatch thread.
   *
   * @throws IOException if it cannot be read or is none; its message is the file and the reason
   */
  static LoadedInstallation load(Path file) throws IOException {
    try {
      Optional<Path> variables =
          InstallationFile.variablesOf(file.toString()).map(Path::of).filter(Files::isRegularFile);
      Optional<byte[]> values =
          variables.isPresent() ? Optional.of(bytes(variables.get())) : Optional.empty();
      return InstallationFile.read(file.toString(), bytes(file), values);
    } catch (InstallationTrouble e) {
      throw new IOException(e.getMessage(), e);
    }
  }

  private static byte[] bytes(Path file) throws IOException {
    try {
      if (Files.size(file) > InstallationFile.MAX_BYTES) {
        throw new IOException(text("itHasMoreThanBytes", InstallationFile.MAX_BYTES));
      }
      return Files.readAllBytes(file);
    } catch (IOException e) {
      throw new IOException(file + ": " + FileTrouble.reason(e), e);
    }
  }

  /** The document of an installation that the desktop has begun with. */
  void begin(StartInstallation start) {
    if (isOurs(start.file())) {
      read(start.file());
    } else {
      active.open(untitledOf(start.file(), start.installation()));
    }
  }

  /**
   * Saves it where it is, or asks where.
   *
   * @param then hears whether it is on disk now
   */
  void save(Consumer<Boolean> then) {
    ProgramDocument document = active.document();
    if (document.file().isEmpty()) {
      saveAs(document, then);
    } else {
      saver.save(document, remembering(document, then));
    }
  }

  private void saveAs(ProgramDocument document, Consumer<Boolean> then) {
    Path here = document.file().orElse(Path.of(document.name()));
    SaveDialog.ask(
        parent,
        new SaveRequest(
            text("saveAs", document.name()),
            document.file().isPresent() ? here.toAbsolutePath() : used.get().resolve(here),
            List.of(InstallationText.ENDING.substring(1)),
            InstallationFiles::fitting,
            List.of()),
        chosen ->
            chosen.ifPresentOrElse(
                path ->
                    saver.saveAs(document, document.toSaveAs(path), remembering(document, then)),
                () -> then.accept(false)));
  }

  /** An installation is known by the ending of its file. */
  private static Path fitting(Path path) {
    return isOurs(path) ? path : path.resolveSibling(path.getFileName() + InstallationText.ENDING);
  }

  private Consumer<Boolean> remembering(ProgramDocument document, Consumer<Boolean> then) {
    return saved -> {
      if (saved) {
        document.file().ifPresent(this::remember);
      }
      then.accept(saved);
    };
  }

  private void reload() {
    ProgramDocument document = active.document();
    document
        .file()
        .ifPresent(
            path ->
                Background.run(
                    () -> SavedProgram.read(path),
                    document::reloaded,
                    failed -> warn.accept(text("notRead", failed.getMessage()))));
  }

  /** It is opened again at the next start. */
  private void rememberOpen() {
    if (!active.ofArm()) {
      settings.put(
          OPEN, active.document().file().map(file -> file.toAbsolutePath().toString()).orElse(""));
    }
  }

  private void remember(Path file) {
    List<String> names = new ArrayList<>();
    names.add(file.toAbsolutePath().toString());
    recent().stream().map(Path::toString).filter(each -> !names.contains(each)).forEach(names::add);
    settings.put(RECENT, String.join("\n", names.subList(0, Math.min(MAX_RECENT, names.size()))));
  }

  /** The installations that were open lately, the last one first. */
  List<Path> recent() {
    return ProgramFiles.files(settings, RECENT);
  }

  /** The file that was open at the end. */
  static Optional<Path> openLastTime(Settings settings) {
    return ProgramFiles.files(settings, OPEN).stream().findFirst();
  }
}
