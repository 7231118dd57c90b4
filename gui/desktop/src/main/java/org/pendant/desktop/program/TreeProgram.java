package org.pendant.desktop.program;

import static org.pendant.desktop.program.ProgramViewTexts.text;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.Executor;
import java.util.concurrent.atomic.AtomicLong;
import java.util.function.LongSupplier;
import java.util.function.Supplier;
import org.pendant.controller.installation.Installation;
import org.pendant.desktop.session.ProgramDocument;
import org.pendant.project.program.ProgramTree;
import org.pendant.project.program.check.NodeProblem;
import org.pendant.project.program.check.ProgramCheck;
import org.pendant.project.program.script.GeneratedScript;
import org.pendant.project.program.script.ScriptGenerator;
import org.pendant.project.program.text.ProgramText;
import org.pendant.project.program.text.ReadProgram;
import org.pendant.project.program.text.TextProblem;
import org.pendant.project.program.urp.ShownNodes;

/**
 * Tree program: an open program whose text is a tree: each change of the tree is written into the
 * text at once, and a text that changes some other way is read again. What the tree generates and
 * what keeps it from running follow a moment later. It has no Swing; one thread uses it, the one
 * behind its display.
 */
public final class TreeProgram implements ProgramDocument.Listener {
  private final ProgramDocument document;
  private final Supplier<Installation> installation;
  private final Executor worker;
  private final Executor display;
  private final ScriptSink sink;
  private final TreeHistory history;
  private final NodeBreakpoints breakpoints = new NodeBreakpoints();
  private final List<Listener> listeners = new ArrayList<>();

  /** What the text says. */
  private ProgramTree written;

  /** What is shown of that. */
  private ProgramTree tree;

  private List<TextProblem> textProblems = List.of();
  private Found found = new Found(0, GeneratedScript.EMPTY, List.of());
  private Map<Long, List<NodeProblem>> problemsByKey = Map.of();
  private final List<Runnable> waiting = new ArrayList<>();
  private final AtomicLong version = new AtomicLong();
  private String checkedName = "";
  private boolean readOnly;
  private boolean writing;

  /** Who wants to know. */
  public interface Listener {

    /** The tree is another one, or the text cannot be read as one. */
    default void treeChanged() {}

    /** What the tree generates, or what keeps it from running, is known anew. */
    default void checked() {}
  }

  /** Where the generated script is shown. */
  @FunctionalInterface
  public interface ScriptSink {
    /**
     * Replaces the script of a program.
     *
     * @param before what is shown now
     */
    void show(TreeProgram program, GeneratedScript before, GeneratedScript now);
  }

  /** What was found out about the tree of a version. */
  private record Found(long version, GeneratedScript script, List<NodeProblem> problems) {}

  /**
   * The tree of a document.
   *
   * @param installation what the program can refer to, asked anew each time
   * @param worker runs what takes long, one after the other
   * @param display runs what follows that in the thread that uses this object
   * @param clockMs any clock that runs, ms
   */
  TreeProgram(
      ProgramDocument document,
      Supplier<Installation> installation,
      Executor worker,
      Executor display,
      ScriptSink sink,
      LongSupplier clockMs) {
    this.document = document;
    this.installation = installation;
    this.worker = worker;
    this.display = display;
    this.sink = sink;
    history = new TreeHistory(clockMs);
    ReadProgram read = read(document.text());
    take(read.tree());
    textProblems = read.problems();
    document.addListener(this);
    check();
  }

  /** A text without anything in it is a new program. */
  private static ReadProgram read(String text) {
    return text.isBlank()
        ? new ReadProgram(ProgramTree.empty(), List.of())
        : ProgramText.read(text);
  }

  private void take(ProgramTree next) {
    readOnly = document.readOnly();
    written = next;
    tree = readOnly ? ForeignTree.shown(next) : next;
  }

  /** The document whose text the tree is. */
  public ProgramDocument document() {
    return document;
  }

  /** The tree as it is now; while there are {@link #textProblems} what could be read of it. */
  public ProgramTree tree() {
    return tree;
  }

  /** The tree as the text has it, where it is shown otherwise. */
  ProgramTree written() {
    return written;
  }

  /** Why the tree cannot be changed; empty if it can. */
  Optional<String> whyNotChanged() {
    return readOnly
        ? Optional.of(text("polyscopeXIsNotChanged", document.name()))
        : Optional.empty();
  }

  /** Why the text is no tree; while there are any, the tree cannot be changed. */
  public List<TextProblem> textProblems() {
    return textProblems;
  }

  /** What the program can refer to. */
  public Installation installation() {
    return installation.get();
  }

  // --- changes

  /**
   * Replaces the tree, unless the text is none or {@link #whyNotChanged} has a reason.
   *
   * @param what people read when they undo it
   * @param key of the node that it is about, 0 for none: changes of one node with the same words
   *     within a short time are one
   */
  public void change(String what, long key, ProgramTree next) {
    if (readOnly || next.equals(tree) || !textProblems.isEmpty()) {
      return;
    }
    history.changing(what, key, tree);
    show(next);
  }

  /** Takes the last change back; the key of the node that it was about, if it was about one. */
  Optional<Long> undo() {
    return turned(history.undo(tree));
  }

  /** Does what was taken back again; the key of the node that it was about. */
  Optional<Long> redo() {
    return turned(history.redo(tree));
  }

  private Optional<Long> turned(Optional<TreeHistory.Change> change) {
    change.ifPresent(each -> show(each.tree()));
    return change.map(TreeHistory.Change::key);
  }

  /** What can be undone and done again. */
  TreeHistory history() {
    return history;
  }

  /** Which nodes the breakpoints in its script stand beside. */
  NodeBreakpoints breakpoints() {
    return breakpoints;
  }

  private void show(ProgramTree next) {
    take(next);
    writing = true;
    document.setText(ProgramText.write(next));
    writing = false;
    check();
    listeners().forEach(Listener::treeChanged);
  }

  @Override
  public void textChanged(int offset, int removed, String added) {
    if (writing) {
      return;
    }
    ReadProgram read = read(document.text());
    if (read.problems().isEmpty()) {
      if (!readOnly) {
        history.changing(text("changeTheText"), 0, tree);
      }
      take(KeptKeys.of(written, read.tree()));
    }
    textProblems = read.problems();
    check();
    listeners().forEach(Listener::treeChanged);
  }

  @Override
  public void fileChanged() {
    boolean freed = readOnly != document.readOnly();
    if (freed) {
      take(written);
    }
    // The script is called like its file.
    if (freed || !programName().equals(checkedName)) {
      check();
    }
    if (freed) {
      listeners().forEach(Listener::treeChanged);
    }
  }

  // --- what follows from the tree

  /** Something else than the tree has changed that the script depends on. */
  void check() {
    long wanted = version.incrementAndGet();
    ProgramTree checked = written;
    boolean foreign = readOnly;
    Installation with = installation.get();
    String name = programName();
    checkedName = name;
    boolean readable = textProblems.isEmpty();
    worker.execute(
        () -> {
          if (wanted == version.get() && readable) {
            GeneratedScript own = ScriptGenerator.generate(name, checked, with);
            GeneratedScript script = foreign ? ShownNodes.placed(checked, own) : own;
            List<NodeProblem> problems = ProgramCheck.problems(checked, with);
            display.execute(() -> found(new Found(wanted, script, problems)));
          }
        });
  }

  /** What the program is called in its script. */
  String programName() {
    return document.bareName();
  }

  private void found(Found now) {
    if (now.version() != version.get()) {
      return;
    }
    GeneratedScript before = found.script();
    found = now;
    Map<Long, List<NodeProblem>> byKey = new HashMap<>();
    now.problems()
        .forEach(each -> byKey.computeIfAbsent(each.key(), key -> new ArrayList<>()).add(each));
    problemsByKey = byKey;
    sink.show(this, before, now.script());
    listeners().forEach(Listener::checked);
    List<Runnable> actions = List.copyOf(waiting);
    waiting.clear();
    actions.forEach(Runnable::run);
  }

  /** Runs an action as soon as script and problems are those of the tree as it is. */
  public void whenChecked(Runnable action) {
    if (found.version() == version.get()) {
      action.run();
    } else {
      waiting.add(action);
    }
  }

  /** What the tree generates; of an older tree until {@link Listener#checked}. */
  public GeneratedScript script() {
    return found.script();
  }

  /** What keeps the tree from running; of an older tree until {@link Listener#checked}. */
  public List<NodeProblem> problems() {
    return found.problems();
  }

  /** What keeps one node from running. */
  public List<NodeProblem> problems(long key) {
    return problemsByKey.getOrDefault(key, List.of());
  }

  /** Tells {@code listener} from now on. */
  public void addListener(Listener listener) {
    listeners.add(listener);
  }

  /** Ends {@link #addListener}. */
  public void removeListener(Listener listener) {
    listeners.remove(listener);
  }

  private List<Listener> listeners() {
    return List.copyOf(listeners);
  }
}
