package org.pendant.desktop.program;

import static org.pendant.desktop.program.ProgramViewTexts.text;

import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.OptionalLong;
import java.util.Set;
import java.util.SortedSet;
import java.util.function.BiFunction;
import java.util.function.Consumer;
import java.util.function.Function;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.pendant.controller.state.ControllerState;
import org.pendant.desktop.debug.DebugPresenter;
import org.pendant.desktop.debug.EditorLink;
import org.pendant.desktop.editor.Execution;
import org.pendant.desktop.editor.LineIcon;
import org.pendant.desktop.editor.LineNote;
import org.pendant.desktop.editor.ScriptEditor;
import org.pendant.desktop.session.ProgramDocument;
import org.pendant.project.program.ProgramNode;
import org.pendant.project.program.script.GeneratedScript;
import org.pendant.project.program.script.GeneratedScript.NodeLines;
import org.pendant.script.debug.Breakpoint;
import org.pendant.script.vm.ThreadSnapshot;

/**
 * Script link: keeps the tree of a program and the script that it generates together: breakpoints,
 * the place where the program is, and what is selected.
 */
public final class ScriptLink implements TreeProgram.ScriptSink {
  /** A line that says which node comes next. */
  private static final Pattern LABEL = Pattern.compile("^\\s*\\$ ([1-9]\\d{0,6}) ");

  private final ScriptEditor editor;
  private final DebugPresenter debug;
  private final Consumer<String> tell;
  private final NodeWarnings warnings;
  private int seenCaret;
  private Optional<ProgramDocument> seenIn = Optional.empty();
  private BiFunction<ProgramDocument, GeneratedScript, Map<Long, LineNote>> notes =
      (document, script) -> Map.of();
  private Function<ProgramDocument, OptionalInt> past = document -> OptionalInt.empty();

  /** Links trees with {@code editor}, which shows their scripts. */
  public ScriptLink(ScriptEditor editor, DebugPresenter debug, Consumer<String> tell) {
    this.editor = editor;
    this.debug = debug;
    this.tell = tell;
    warnings = new NodeWarnings(editor);
  }

  /** What the check of scripts warns of, by node. */
  NodeWarnings warnings() {
    return warnings;
  }

  // --- the script

  @Override
  public void show(TreeProgram program, GeneratedScript before, GeneratedScript now) {
    NodeBreakpoints breakpoints = program.breakpoints();
    NodeBreakpoints.Lines lines = lines(program);
    breakpoints.forgetCleared(lines);
    editor.replaceScript(
        program.document(), now.text(), line -> breakpoints.moved(before, now, line));
    breakpoints.follow(before, now, lines);
    seenCaret = editor.caretLine();
  }

  /**
   * Has the tree show the moment that people look at.
   *
   * @param line of the script of a program at that moment, 0 where it did not run; empty for now
   */
  public void setPast(Function<ProgramDocument, OptionalInt> line) {
    past = line;
  }

  /** Asks {@code known} what the nodes of a program took of the last run. */
  public void setNotes(BiFunction<ProgramDocument, GeneratedScript, Map<Long, LineNote>> known) {
    notes = known;
  }

  // --- breakpoints

  /** Sets a breakpoint where a node begins, or clears those of the node. */
  void toggleBreakpoint(TreeProgram program, long key) {
    program.whenChecked(
        () -> {
          if (!program.breakpoints().toggle(program.script(), key, lines(program))) {
            tell.accept(text("noBreakpointTheNodeGeneratesNothing"));
          }
        });
  }

  private NodeBreakpoints.Lines lines(TreeProgram program) {
    return new NodeBreakpoints.Lines() {
      @Override
      public SortedSet<Integer> all() {
        return editor.breakpoints(program.document());
      }

      @Override
      public void toggle(int line) {
        editor.toggleBreakpoint(program.document(), line);
      }
    };
  }

  // --- what stands beside the nodes

  /** What stands beside the nodes of a program now. */
  TreeMarks marks(TreeProgram program, ControllerState state) {
    GeneratedScript script = program.script();
    Map<Long, LineIcon.Dot> dots = new HashMap<>();
    program.breakpoints().forgetCleared(lines(program));
    for (Breakpoint each : debug.breakpoints().all(program.document())) {
      LineIcon.Dot dot =
          new LineIcon.Dot(each.enabled(), EditorLink.kind(each), LineIcon.Reach.HERE);
      program.breakpoints().nodes(script, each.line()).forEach(key -> dots.put(key, dot));
    }
    Map<Long, LineNote> took = notes.apply(program.document(), script);
    OptionalInt then = past.apply(program.document());
    if (then.isPresent()) {
      long key = key(script, then.getAsInt());
      return new TreeMarks(dots, key, Execution.State.RUNNING, "", Set.of(), took);
    }
    boolean started = debug.breakpoints().started().filter(program.document()::equals).isPresent();
    if (!started) {
      return new TreeMarks(dots, 0, Execution.State.RUNNING, "", Set.of(), took);
    }
    Execution execution = debug.execution(state);
    long at = key(script, execution.line());
    return new TreeMarks(dots, at, execution.state(), execution.note(), threads(script, at), took);
  }

  /** Where a program is in its script, now or at the moment that people look at. */
  Execution execution(TreeProgram program, ControllerState state) {
    OptionalInt then = past.apply(program.document());
    if (then.isPresent()) {
      return Execution.running(then.getAsInt());
    }
    boolean started = debug.breakpoints().started().filter(program.document()::equals).isPresent();
    return started ? debug.execution(state) : Execution.NONE;
  }

  /** The key of the node where a program is; 0 for none. */
  long at(TreeProgram program, ControllerState state) {
    boolean started = debug.breakpoints().started().filter(program.document()::equals).isPresent();
    return started ? key(program.script(), debug.execution(state).line()) : 0;
  }

  private Set<Long> threads(GeneratedScript script, long main) {
    debug.lookAtThreads();
    Set<Long> keys = new HashSet<>();
    for (ThreadSnapshot thread : debug.threads()) {
      boolean inText = !thread.stack().getFirst().source().equals("interpreter");
      if (thread.id() != 0 && inText) {
        keys.add(key(script, debug.lineNow(thread.line())));
      }
    }
    keys.remove(0L);
    keys.remove(main);
    return keys;
  }

  static long key(GeneratedScript script, int line) {
    return line < 1 ? 0 : script.at(line).map(NodeLines::key).orElse(0L);
  }

  // --- selection

  /** A node was selected: the script shows its first line, unless it shows one of it already. */
  void selected(TreeProgram program, long key) {
    Optional<NodeLines> place = program.script().of(key);
    int caret = editor.caretLine();
    if (place.isPresent()
        && program.script().at(caret).filter(there -> there.key() == key).isEmpty()) {
      editor.show(place.get().first(), 1);
    }
    seen(program);
  }

  private void seen(TreeProgram program) {
    seenCaret = editor.caretLine();
    seenIn = Optional.of(program.document());
  }

  /** The node of a line, also where the line is its label; 0 for none. */
  private static long nodeAt(TreeProgram program, int line) {
    String text =
        program.script().text().lines().skip(Math.max(0, line - 1)).findFirst().orElse("");
    long labelled = labelled(program, text);
    return labelled != 0 ? labelled : key(program.script(), line);
  }

  /** The node that a line of a script is the label of; 0 for none. */
  static long labelled(TreeProgram program, String text) {
    Matcher label = LABEL.matcher(text);
    List<ProgramNode> nodes = program.tree().nodes();
    boolean found = label.find() && Integer.parseInt(label.group(1)) <= nodes.size();
    return found ? nodes.get(Integer.parseInt(label.group(1)) - 1).key() : 0;
  }

  /** The node where the user has put the caret of the script since the last call. */
  OptionalLong caretMoved(TreeProgram program) {
    boolean other = !seenIn.equals(Optional.of(program.document()));
    boolean moved = editor.caretLine() != seenCaret;
    seen(program);
    if (other || !moved) {
      return OptionalLong.empty();
    }
    long key = nodeAt(program, seenCaret);
    return key == 0 ? OptionalLong.empty() : OptionalLong.of(key);
  }
}
