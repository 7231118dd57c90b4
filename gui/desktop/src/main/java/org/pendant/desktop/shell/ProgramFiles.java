package org.pendant.desktop.shell;

import static org.pendant.desktop.shell.ShellTexts.text;

import java.awt.Component;
import java.io.IOException;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.stream.Stream;
import org.pendant.desktop.session.ProgramDocument;
import org.pendant.desktop.session.Programs;
import org.pendant.desktop.session.SavedProgram;
import org.pendant.desktop.shell.Notices.Choice;
import org.pendant.kit.background.Background;
import org.pendant.kit.export.SaveDialog;
import org.pendant.kit.export.SaveRequest;
import org.pendant.kit.settings.Settings;
import org.pendant.project.program.ProgramTree;
import org.pendant.project.program.file.TreeFile;
import org.pendant.project.program.text.ProgramText;

/**
 * Program files: opens and saves programs. Only the dispatch thread calls it; it reads and writes
 * elsewhere.
 */
final class ProgramFiles {
  private static final String RECENT = "file.recent";
  private static final String OPEN = "file.open";
  private static final String FRONT = "file.front";
  private static final int MAX_RECENT = 10;

  private final Programs programs;
  private final DocumentSaver saver;
  private final Settings settings;
  private final Notices notices;
  private final Consumer<String> tell;
  private final Consumer<String> warn;
  private final UsedFolder used;
  private final Component parent;
  private Consumer<ProgramDocument> shower = program -> {};
  private Consumer<Path> chosen = this::open;
  private final Deque<Path> toRead = new ArrayDeque<>();
  private int untitled = 1;

  /**
   * Files of {@code programs}.
   *
   * @param tell tells what was done
   * @param warn tells what was not done, so that it cannot be overlooked
   * @param used where dialogs begin
   * @param parent dialogs belong to its window
   */
  ProgramFiles(
      Programs programs,
      DocumentSaver saver,
      Settings settings,
      Notices notices,
      Consumer<String> tell,
      Consumer<String> warn,
      UsedFolder used,
      Component parent) {
    this.programs = programs;
    this.saver = saver;
    this.settings = settings;
    this.notices = notices;
    this.tell = tell;
    this.warn = warn;
    this.used = used;
    this.parent = parent;
    programs.addListener(this::rememberOpen);
  }

  /** {@code how} shows the program that a user has just made or opened. */
  void showBy(Consumer<ProgramDocument> how) {
    shower = how;
  }

  /** {@code how} opens a file that people have chosen, which may be no program. */
  void openBy(Consumer<Path> how) {
    chosen = how;
  }

  private void select(ProgramDocument program) {
    programs.select(program);
    shower.accept(program);
  }

  /** A new program without nodes. */
  void create() {
    select(
        ProgramDocument.untitled(
            newName() + ProgramDocument.TREE, ProgramText.write(ProgramTree.empty())));
  }

  /** A new script with a frame to fill. */
  void createScript() {
    String name = newName();
    select(
        ProgramDocument.untitled(name + ProgramDocument.SCRIPT, "def " + name + "():\n  \nend\n"));
  }

  private String newName() {
    String name = "untitled" + (untitled == 1 ? "" : untitled);
    untitled++;
    return name;
  }

  /** Asks for a file and opens it. */
  void open() {
    OpenDialog.show(
        parent,
        text("openProgramTitle"),
        text("programsAndScripts"),
        new String[] {"pendant", "urp", "urpx", "script", "urscript"},
        used,
        chosen);
  }

  private Optional<Path> folder() {
    return programs.current().file().map(Path::getParent);
  }

  /**
   * Opens a file, or selects it if it is open; several come in the order in which they are asked
   * for.
   */
  void open(Path file) {
    toRead.add(file);
    if (toRead.size() == 1) {
      openNext();
    }
  }

  private void openNext() {
    Path file = toRead.getFirst();
    Optional<ProgramDocument> already = programs.of(file);
    if (already.isPresent()) {
      opened(() -> select(already.get()));
    } else if (ForeignProgram.is(file)) {
      Background.run(
          () -> ForeignProgram.read(file),
          read -> opened(() -> show(read)),
          failed -> opened(() -> notOpened(failed)));
    } else {
      Background.run(
          () -> SavedProgram.read(file),
          read -> opened(() -> show(read)),
          failed ->
              opened(
                  () -> {
                    notOpened(failed);
                    forget(file);
                  }));
    }
  }

  /** Goes on with the next file whatever comes of showing this one. */
  private void opened(Runnable shown) {
    toRead.removeFirst();
    try {
      shown.run();
    } finally {
      if (!toRead.isEmpty()) {
        openNext();
      }
    }
  }

  private void notOpened(IOException failed) {
    warn.accept(text("notOpened", failed.getMessage()));
  }

  /** The file itself stays as it is: what was read from it is a new program. */
  private void show(ForeignProgram read) {
    ProgramDocument before = programs.current();
    ProgramDocument fresh =
        ProgramDocument.untitled(read.name() + ProgramDocument.TREE, read.text());
    fresh.gone();
    select(fresh);
    closeUntouched(before);
    tell.accept(text("openedACopyOfAProgram", read.file()));
    read.remarks().forEach(warn);
  }

  /** Opens a text that is no file of the user's as a program without a file. */
  void openCopy(String name, String text) {
    ProgramDocument before = programs.current();
    select(ProgramDocument.untitled(name, text));
    closeUntouched(before);
  }

  /** As {@link #openCopy}, behind the current program, which stays. */
  void openBehind(String name, String text) {
    programs.open(ProgramDocument.untitled(name, text));
  }

  private void show(SavedProgram read) {
    // Another command may have opened it meanwhile.
    Optional<ProgramDocument> already = programs.of(read.path());
    ProgramDocument before = programs.current();
    select(already.orElseGet(() -> ProgramDocument.of(read)));
    closeUntouched(before);
    remember(read.path());
  }

  /** The example, or a new program that has not been touched. */
  private void closeUntouched(ProgramDocument before) {
    if (before.file().isEmpty() && !before.modified()) {
      programs.close(before, before);
    }
  }

  /** Asks where to save the script of a program tree. */
  void saveScript(ProgramDocument document) {
    ProgramDocument script = document.script();
    SaveDialog.ask(
        parent,
        new SaveRequest(
            text("saveTheScriptOfAs", document.name()),
            folder().orElse(used.get()).resolve(script.name()),
            List.of("script"),
            EditedFiles.besides(script, programs)),
        chosen -> chosen.ifPresent(path -> saver.export(SavedProgram.create(path, script.text()))));
  }

  /** Saves a program where it is, or asks where. */
  void save(ProgramDocument document) {
    save(document, saved -> {});
  }

  /**
   * As {@link #save(ProgramDocument)}.
   *
   * @param then hears whether it is on disk now
   */
  void save(ProgramDocument document, Consumer<Boolean> then) {
    if (document.readOnly()) {
      offerCopies(document);
      then.accept(false);
    } else if (document.file().isEmpty()) {
      saveAs(document, then);
    } else {
      saver.save(document, remembering(document, then));
    }
  }

  private void offerCopies(ProgramDocument document) {
    notices.ask(
        "read-only-" + System.identityHashCode(document),
        text("isNotSavedProgramsOfPolyscope", document.name()),
        List.of(
            new Choice(
                "save-a-copy-as-program", text("saveACopyAsProgram"), () -> saveAs(document)),
            new Choice(
                "save-a-copy-as-script", text("saveACopyAsScript"), () -> saveScript(document)),
            Choice.nothing("close", text("close"))));
  }

  /** Asks where to save a program. */
  void saveAs(ProgramDocument document) {
    saveAs(document, saved -> {});
  }

  private void saveAs(ProgramDocument document, Consumer<Boolean> then) {
    Path here = fitting(document, document.file().orElse(Path.of(document.name())));
    SaveDialog.ask(
        parent,
        new SaveRequest(
            text("saveAs", document.name()),
            document.file().isPresent()
                ? here.toAbsolutePath()
                : folder().orElse(used.get()).resolve(here),
            List.of(document.isTree() ? "pendant" : "script"),
            path -> fitting(document, path),
            EditedFiles.besides(document, programs)),
        chosen ->
            chosen.ifPresentOrElse(
                path ->
                    saver.saveAs(document, document.toSaveAs(path), remembering(document, then)),
                () -> then.accept(false)));
  }

  /** A tree is known by the ending of its file. */
  private static Path fitting(ProgramDocument document, Path path) {
    String name = path.getFileName().toString();
    if (!document.isTree() || name.endsWith(ProgramDocument.TREE)) {
      return path;
    }
    String bare = TreeFile.isForeign(name) ? name.substring(0, name.lastIndexOf('.')) : name;
    return path.resolveSibling(bare + ProgramDocument.TREE);
  }

  private Consumer<Boolean> remembering(ProgramDocument document, Consumer<Boolean> then) {
    return saved -> {
      if (saved) {
        document.file().ifPresent(this::remember);
        rememberOpen();
      }
      then.accept(saved);
    };
  }

  /** Takes the text from disk again. */
  void reload(ProgramDocument document) {
    document
        .file()
        .ifPresent(
            path ->
                Background.run(
                    () -> SavedProgram.read(path),
                    document::reloaded,
                    failed -> warn.accept(text("notRead", failed.getMessage()))));
  }

  /** The files that are open now are opened again at the next start. */
  private void rememberOpen() {
    settings.put(
        OPEN,
        String.join(
            "\n",
            programs.all().stream()
                .flatMap(each -> each.file().stream())
                .map(file -> file.toAbsolutePath().toString())
                .toList()));
    settings.put(
        FRONT, programs.current().file().map(file -> file.toAbsolutePath().toString()).orElse(""));
  }

  /** The file of the program that people saw at the end, else the one that was opened last. */
  static Optional<Path> inFrontLastTime(Settings settings) {
    return Stream.of(FRONT, RECENT).flatMap(each -> files(settings, each).stream()).findFirst();
  }

  /** The files that were open at the end, in the order of their tabs. */
  static List<Path> openLastTime(Settings settings) {
    return files(settings, OPEN);
  }

  private void forget(Path file) {
    String name = file.toAbsolutePath().toString();
    putRecent(recent().stream().map(Path::toString).filter(each -> !each.equals(name)).toList());
  }

  private void remember(Path file) {
    String name = file.toAbsolutePath().toString();
    List<String> recent = new ArrayList<>();
    recent.add(name);
    recent().stream().map(Path::toString).filter(each -> !each.equals(name)).forEach(recent::add);
    putRecent(recent);
  }

  private void putRecent(List<String> recent) {
    settings.put(RECENT, String.join("\n", recent.subList(0, Math.min(MAX_RECENT, recent.size()))));
  }

  /** The files that were open lately, the last one first. */
  List<Path> recent() {
    return recent(settings);
  }

  /** As {@link #recent()}. */
  static List<Path> recent(Settings settings) {
    return files(settings, RECENT);
  }

  /** The files that a setting lists. */
  static List<Path> files(Settings settings, String name) {
    return settings.get(name).orElse("").lines().flatMap(line -> path(line).stream()).toList();
  }

  /** People may have written anything into the settings. */
  private static Optional<Path> path(String line) {
    try {
      return line.isBlank() ? Optional.empty() : Optional.of(Path.of(line));
    } catch (InvalidPathException e) {
      return Optional.empty();
    }
  }
}
