package org.pendant.desktop.session;

import java.util.ArrayList;
import java.util.List;
import org.pendant.controller.installation.Installation;
import org.pendant.project.installation.text.InstallationText;
import org.pendant.project.installation.text.ReadInstallation;
import org.pendant.project.program.text.TextProblem;

/**
 * Active installation: the one that the desktop works with, and the document that it is written in.
 * One thread uses it, the dispatch thread.
 */
public final class ActiveInstallation {
  /** What an installation is called that was never saved. */
  public static final String UNTITLED = "untitled" + InstallationText.ENDING;

  private final List<Runnable> listeners = new ArrayList<>();
  private final List<Runnable> fileListeners = new ArrayList<>();
  private final ProgramDocument.Listener follower = new Follower();
  private ProgramDocument document =
      ProgramDocument.untitled(UNTITLED, InstallationText.write(Installation.NONE));
  private Installation current = Installation.NONE;
  private String problem = "";
  private String waiting = "";
  private boolean writing;
  private boolean ofArm;

  /** Nothing is set up. */
  public ActiveInstallation() {
    document.addListener(follower);
  }

  /** Hears what the document is told by others, such as the watch of the disk. */
  private final class Follower implements ProgramDocument.Listener {
    @Override
    public void textChanged(int offset, int removed, String added) {
      if (!writing) {
        read();
      }
    }

    @Override
    public void fileChanged() {
      tellFile();
    }
  }

  /** What is set up now. */
  public Installation current() {
    return current;
  }

  /** Where it is written: a file, or a text without one. */
  public ProgramDocument document() {
    return document;
  }

  /**
   * What is wrong with the text in the document, with its line; empty if it says what is set up.
   */
  public String problem() {
    return problem;
  }

  /** Why the controller is not set up so yet; empty if it is. */
  public String waiting() {
    return waiting;
  }

  /** Says why the controller is not set up so yet; empty if it is. */
  public void setWaiting(String why) {
    waiting = why;
  }

  /** Whether it is that of an arm of a cell, and comes with the scene. */
  public boolean ofArm() {
    return ofArm;
  }

  /** Says whether those to come are of arms of a cell. */
  public void setOfArm(boolean of) {
    ofArm = of;
  }

  /** Sets it up anew. */
  public void set(Installation next) {
    if (!next.equals(current)) {
      current = next;
      problem = "";
      writing = true;
      document.setText(text(next));
      writing = false;
      tell();
    }
  }

  /** What is on disk may be written another way: who is back there has nothing to save. */
  private String text(Installation next) {
    return document
        .onDisk()
        .map(SavedProgram::text)
        .filter(text -> says(text, next))
        .orElseGet(() -> InstallationText.write(next));
  }

  private static boolean says(String text, Installation wanted) {
    ReadInstallation read = InstallationText.read(text);
    return read.problems().isEmpty() && read.installation().equals(wanted);
  }

  /** What the controller was started with, unless a document says just this already. */
  public void begin(Installation started) {
    if (!started.equals(current)) {
      open(ProgramDocument.untitled(UNTITLED, InstallationText.write(started)));
    }
  }

  /**
   * Takes another document. Where its text is no installation {@link #problem} says why, and what
   * is set up stays as it is.
   */
  public void open(ProgramDocument other) {
    document.removeListener(follower);
    document = other;
    document.addListener(follower);
    read();
    tellFile();
  }

  private void read() {
    ReadInstallation read = InstallationText.read(document.text());
    problem = read.problems().stream().findFirst().map(this::words).orElse("");
    if (problem.isEmpty() && !read.installation().equals(current)) {
      current = read.installation();
      tell();
    } else {
      tellFile();
    }
  }

  private String words(TextProblem first) {
    return document.name() + ":" + first.line() + ":" + first.column() + ": " + first.message();
  }

  /** Tells {@code listener} of every change from now on. */
  public void addListener(Runnable listener) {
    listeners.add(listener);
  }

  /** Tells {@code listener} of another document or another modified mark from now on. */
  public void addFileListener(Runnable listener) {
    fileListeners.add(listener);
  }

  private void tell() {
    List.copyOf(listeners).forEach(Runnable::run);
  }

  private void tellFile() {
    List.copyOf(fileListeners).forEach(Runnable::run);
  }
}
