package org.pendant.desktop.session;

import java.nio.charset.Charset;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.pendant.language.source.Source;
import org.pendant.project.program.file.TreeFile;

/**
 * Program document: a program that is open: its text, and what of it is on disk. It reads and
 * writes nothing itself. One thread uses it, the dispatch thread.
 */
public final class ProgramDocument {
  /** Ending of the names of files that hold program trees. */
  public static final String TREE = ".pendant";

  /** Ending of the names of files that hold scripts. */
  public static final String SCRIPT = ".script";

  private final List<Listener> listeners = new ArrayList<>();
  private final String untitledName;
  private final Optional<ProgramDocument> tree;
  private Optional<ProgramDocument> generated = Optional.empty();
  private Optional<SavedProgram> onDisk;
  private String savedText;
  private String text;
  private boolean gone;
  private boolean received;

  /** Who wants to know. */
  public interface Listener {

    /**
     * A stretch of the text was replaced.
     *
     * @param offset where it began, in characters
     * @param removed how many characters went
     * @param added what came
     */
    default void textChanged(int offset, int removed, String added) {}

    /** Another file, or the modified mark has changed. */
    default void fileChanged() {}
  }

  private ProgramDocument(
      String untitledName,
      Optional<SavedProgram> onDisk,
      String text,
      Optional<ProgramDocument> tree) {
    this.untitledName = untitledName;
    this.tree = tree;
    this.onDisk = onDisk;
    this.text = text;
    savedText = text;
  }

  /** A program without a file, not modified yet. */
  public static ProgramDocument untitled(String name, String text) {
    return new ProgramDocument(name, Optional.empty(), text, Optional.empty());
  }

  /** A script that was sent to the controller from outside: it cannot be changed, only saved. */
  public static ProgramDocument received(String name, String text) {
    ProgramDocument document = untitled(name, text);
    document.received = true;
    return document;
  }

  /** A program as it was read. */
  public static ProgramDocument of(SavedProgram file) {
    return new ProgramDocument("", Optional.of(file), file.text(), Optional.empty());
  }

  /** Name of the file without its folder, or what was given to one that has none. */
  public String name() {
    return tree.map(ProgramDocument::name)
        .map(ProgramDocument::scriptName)
        .orElseGet(
            () -> onDisk.map(file -> file.path().getFileName().toString()).orElse(untitledName));
  }

  private static String scriptName(String treeName) {
    return isTreeName(treeName) ? withoutEnding(treeName) + SCRIPT : treeName;
  }

  private static boolean isTreeName(String name) {
    return name.endsWith(TREE) || TreeFile.isForeign(name);
  }

  private static String withoutEnding(String treeName) {
    return treeName.substring(0, treeName.lastIndexOf('.'));
  }

  /** Its name, without the ending that files with program trees have. */
  public String bareName() {
    return isTreeName(name()) ? withoutEnding(name()) : name();
  }

  /** Whether the text is a program tree, not a script. */
  public boolean isTree() {
    return tree.isEmpty() && isTreeName(name());
  }

  /** Whether it is a program of PolyScope X, which can be shown and run, but not changed. */
  public boolean readOnly() {
    return onDisk.filter(SavedProgram::readOnly).isPresent();
  }

  /** Whether it was sent to the controller from outside and has not been saved since. */
  public boolean received() {
    return received;
  }

  /**
   * The program as a script: itself, or for a tree a document with what the tree generates, which
   * the owner of the tree keeps up to date.
   */
  public ProgramDocument script() {
    if (!isTree()) {
      return this;
    }
    if (generated.isEmpty()) {
      generated = Optional.of(new ProgramDocument("", Optional.empty(), "", Optional.of(this)));
    }
    return generated.get();
  }

  /** The text; lines end with a line feed. */
  public String text() {
    return text;
  }

  /** Replaces all of the text. */
  public void setText(String wanted) {
    if (!wanted.equals(text)) {
      replace(0, text.length(), wanted);
    }
  }

  /**
   * Replaces a stretch of the text.
   *
   * @param offset where it begins, in characters
   * @param length how many characters go
   * @param added what comes
   * @throws IndexOutOfBoundsException if the stretch is not in the text
   */
  public void replace(int offset, int length, String added) {
    boolean before = modified();
    text = text.substring(0, offset) + added + text.substring(offset + length);
    List.copyOf(listeners).forEach(each -> each.textChanged(offset, length, added));
    if (before != modified()) {
      tellFileChanged();
    }
  }

  /** Whether the text is another one than on disk, or is on disk no more. */
  public boolean modified() {
    return !received && (gone || !text.equals(savedText));
  }

  /** Its file is on disk no more, so that the text is all there is. */
  public void gone() {
    gone = true;
    tellFileChanged();
  }

  /** Where it is on disk. */
  public Optional<Path> file() {
    return onDisk.map(SavedProgram::path);
  }

  /** What was last read from or written to disk. */
  public Optional<SavedProgram> onDisk() {
    return onDisk;
  }

  /** What would be written now, if there is a file. */
  public Optional<SavedProgram> toSave() {
    return onDisk.map(file -> file.withText(text));
  }

  /** The program as Save as writes it: as it was read, except where that cannot be. */
  public SavedProgram toSaveAs(Path path) {
    return onDisk
        .map(file -> file.copyTo(path, text))
        .orElseGet(() -> SavedProgram.create(path, text));
  }

  /** The text as the controller takes it; offsets are those of the bytes in the file's charset. */
  public Source source() {
    Charset charset = onDisk.map(SavedProgram::charset).orElse(StandardCharsets.UTF_8);
    return Source.of(sourceName(), text.getBytes(charset));
  }

  /**
   * What {@link #source} is called; beside the tree that it is generated from, for what it reads
   * from its folder.
   */
  public String sourceName() {
    return tree.map(ProgramDocument::sourceName)
        .map(ProgramDocument::scriptName)
        .orElseGet(() -> file().map(Path::toString).orElse(untitledName));
  }

  /** {@code file} has been written; the text may have changed since. */
  public void saved(SavedProgram file) {
    onDisk = Optional.of(file);
    savedText = file.text();
    gone = false;
    received = false;
    tellFileChanged();
  }

  /** Others have written {@code now} to its file; the text here stays, to replace that. */
  public void changedOnDisk(SavedProgram now) {
    saved(onDisk.map(known -> known.withText(now.text())).orElse(now));
  }

  /** {@code file} has been read again; its text replaces the present one. */
  public void reloaded(SavedProgram file) {
    saved(file);
    setText(file.text());
  }

  /** Tells {@code listener} of every change from now on. */
  public void addListener(Listener listener) {
    listeners.add(listener);
  }

  /** Ends {@link #addListener}. */
  public void removeListener(Listener listener) {
    listeners.remove(listener);
  }

  private void tellFileChanged() {
    List.copyOf(listeners).forEach(Listener::fileChanged);
  }
}
