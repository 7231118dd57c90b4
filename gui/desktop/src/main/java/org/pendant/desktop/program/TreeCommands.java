package org.pendant.desktop.program;

import static org.pendant.desktop.program.ProgramViewTexts.text;

import java.util.ArrayList;
import java.util.Collection;
import java.util.List;
import java.util.Optional;
import java.util.OptionalLong;
import java.util.Set;
import java.util.function.Consumer;
import org.pendant.project.program.ActionStep;
import org.pendant.project.program.NewNodes;
import org.pendant.project.program.NodeKind;
import org.pendant.project.program.ProgramNode;
import org.pendant.project.program.ProgramTree;
import org.pendant.project.program.text.Clip;
import org.pendant.project.program.text.ProgramText;
import org.pendant.text.Language;

/**
 * Tree commands: what people do with the selected nodes of the program in front. It has no Swing.
 */
final class TreeCommands {
  private final Selection selection;
  private final Clipboard clipboard;
  private final Consumer<String> tell;
  private Optional<TreeProgram> program = Optional.empty();

  /** Which nodes are selected. */
  interface Selection {
    /** The keys of the selected nodes. */
    Set<Long> selected();

    /** The one that was chosen last. */
    OptionalLong lead();

    /** Selects others and brings them into view. */
    void select(Collection<Long> keys);
  }

  /** Text on its way from one place to another. */
  interface Clipboard {
    /** The text there; empty for none. */
    String get();

    void put(String text);
  }

  /**
   * No program yet.
   *
   * @param tell tells why something was not done
   */
  TreeCommands(Selection selection, Clipboard clipboard, Consumer<String> tell) {
    this.selection = selection;
    this.clipboard = clipboard;
    this.tell = tell;
  }

  /** The program that is changed from now on. */
  void setProgram(Optional<TreeProgram> wanted) {
    program = wanted;
  }

  /** Whether there is a tree. */
  boolean ready() {
    return program.filter(each -> each.textProblems().isEmpty()).isPresent();
  }

  /** Whether there is a tree that can be changed. */
  boolean editable() {
    return ready() && program.flatMap(TreeProgram::whyNotChanged).isEmpty();
  }

  /** Whether some node is selected that can be taken away or suppressed. */
  boolean canChange() {
    return editable() && canCopy();
  }

  /** Whether some node is selected that can be copied. */
  boolean canCopy() {
    return ready() && !chosen().isEmpty();
  }

  /** Tells why the tree cannot be changed, if that is so. */
  boolean refused() {
    Optional<String> whyNot = program.flatMap(TreeProgram::whyNotChanged);
    whyNot.ifPresent(tell);
    return whyNot.isPresent();
  }

  private ProgramTree tree() {
    return program.map(TreeProgram::tree).orElseGet(ProgramTree::empty);
  }

  private List<ProgramNode> chosen() {
    return TreeEdits.tops(tree(), selection.selected()).stream()
        .filter(TreeEdits::removable)
        .toList();
  }

  private void change(String what, ProgramTree next) {
    program.ifPresent(each -> each.change(what, 0, next));
  }

  /** {@code Delete Wait} for one node, {@code Delete 3 nodes} for several. */
  private static String about(NodeChange change, List<ProgramNode> nodes) {
    return nodes.size() == 1
        ? change.ofOne(NodeLabels.shown(nodes.getFirst().step()))
        : change.of(nodes.size());
  }

  // --- adding

  /** Adds a node of a kind where the selection is. */
  void add(NodeKind kind) {
    if (refused()) {
      return;
    }
    ProgramTree before = tree();
    Optional<NewSpots.Addition> addition = NewSpots.of(before, selection.lead(), kind);
    if (!ready() || addition.isEmpty()) {
      tell.accept(text("noPlaceAtTheSelectedNode", KindTitles.of(kind)));
      return;
    }
    insert(text("addKind", KindTitles.of(kind)), addition.get().nodes(), addition.get().spot());
  }

  private void insert(String what, List<ProgramNode> nodes, Spot spot) {
    ProgramTree before = tree();
    Optional<String> whyNot = before.whyTooDeep(spot.parent(), nodes);
    if (whyNot.isPresent()) {
      tell.accept(whyNot.get());
      return;
    }
    change(what, before.insert(spot.parent(), spot.index(), nodes));
    selectAdded(before, spot, nodes.size());
  }

  /** The nodes that have come; where one only holds another, that one. */
  private void selectAdded(ProgramTree before, Spot spot, int count) {
    List<ProgramNode> beside = tree().childrenOf(spot.parent());
    if (before.equals(tree()) || beside.size() < spot.index() + count) {
      return;
    }
    List<ProgramNode> added = beside.subList(spot.index(), spot.index() + count);
    selection.select(TreeEdits.keys(added));
  }

  /** A node of a kind for this program, not in it yet. */
  ProgramNode make(NodeKind kind) {
    return NewNodes.of(kind, tree());
  }

  /** Adds lines of URScript behind the selection, each as a node. */
  void addScript(String code) {
    if (refused()) {
      return;
    }
    List<ProgramNode> nodes =
        code.lines().map(line -> ProgramTree.node(new ActionStep.ScriptLine(line))).toList();
    if (ready() && !nodes.isEmpty()) {
      NewSpots.spot(tree(), selection.lead(), nodes.getFirst().step(), true)
          .ifPresent(spot -> insert(text("addScript"), nodes, spot));
    }
  }

  /** Puts nodes where the user has dropped them. */
  void drop(TreeDrag.Cargo cargo, Spot spot) {
    if (refused()) {
      return;
    }
    if (!cargo.moved()) {
      insert(
          about(cargo.ofTree() ? NodeChange.COPY : NodeChange.ADD, cargo.nodes()),
          cargo.nodes(),
          spot);
      return;
    }
    moveTo(cargo.nodes(), spot);
  }

  private void moveTo(List<ProgramNode> nodes, Spot spot) {
    change(about(NodeChange.MOVE, nodes), TreeEdits.move(tree(), nodes, spot));
    selection.select(TreeEdits.keys(nodes));
  }

  // --- the selected nodes

  void delete() {
    if (refused()) {
      return;
    }
    List<ProgramNode> nodes = chosen();
    if (nodes.isEmpty()) {
      tell.accept(text("mainProgramStays"));
      return;
    }
    OptionalLong next = TreeEdits.afterDelete(tree(), selection.selected());
    change(about(NodeChange.DELETE, nodes), TreeEdits.delete(tree(), selection.selected()));
    if (next.isPresent()) {
      selection.select(List.of(next.getAsLong()));
    }
  }

  void copy() {
    List<Long> chosen = TreeEdits.keys(chosen());
    if (!chosen.isEmpty()) {
      ProgramTree written = program.orElseThrow().written();
      clipboard.put(TreeClips.write(written, TreeEdits.tops(written, chosen)));
    }
  }

  void cut() {
    if (!refused() && !chosen().isEmpty()) {
      copy();
      delete();
    }
  }

  /** Puts the nodes of the clipboard into the selected node, or behind it. */
  void paste() {
    if (refused()) {
      return;
    }
    Optional<Clip> clip = ProgramText.readClip(clipboard.get());
    if (clip.isEmpty() || clip.get().nodes().isEmpty()) {
      tell.accept(text("thereAreNoNodesOnThe"));
      return;
    }
    ProgramTree before = tree();
    List<ProgramNode> nodes = clip.get().nodes();
    // Who copies a folder and pastes at once wants a second one, not one in the other.
    boolean itself =
        selection.lead().isPresent()
            && before
                .find(selection.lead().getAsLong())
                .filter(each -> each.step().equals(nodes.getFirst().step()))
                .isPresent();
    Optional<Spot> spot = NewSpots.spot(before, selection.lead(), nodes.getFirst().step(), !itself);
    if (spot.isEmpty()) {
      tell.accept(text("noPlaceAtTheSelectedNode", NodeLabels.shown(nodes.getFirst().step())));
      return;
    }
    Optional<String> whyNot = TreeEdits.whyNot(before, nodes, spot.get(), false);
    if (whyNot.isPresent()) {
      tell.accept(whyNot.get());
      return;
    }
    change(about(NodeChange.PASTE, nodes), TreeClips.paste(before, clip.get(), spot.get()));
    selectAdded(before, spot.get(), nodes.size());
  }

  void duplicate() {
    List<ProgramNode> nodes = chosen();
    if (refused() || nodes.isEmpty()) {
      return;
    }
    ProgramTree before = tree();
    Spot behind = TreeEdits.behind(before, nodes.getLast().key());
    Optional<String> whyNot = TreeEdits.whyNot(before, nodes, behind, false);
    if (whyNot.isPresent()) {
      tell.accept(whyNot.get());
      return;
    }
    change(about(NodeChange.DUPLICATE, nodes), TreeEdits.duplicate(before, selection.selected()));
    selectAdded(before, behind, nodes.size());
  }

  /** Moves the selected nodes one line up or down. */
  void shift(boolean down) {
    if (refused()) {
      return;
    }
    List<ProgramNode> nodes = TreeEdits.tops(tree(), selection.selected());
    TreeEdits.shifted(tree(), nodes, down).ifPresent(spot -> moveTo(nodes, spot));
  }

  void suppress() {
    List<ProgramNode> nodes = chosen();
    if (!refused() && !nodes.isEmpty()) {
      boolean on = nodes.stream().allMatch(ProgramNode::suppressed);
      change(
          about(on ? NodeChange.USE : NodeChange.SUPPRESS, nodes),
          TreeEdits.toggleSuppressed(tree(), TreeEdits.keys(nodes)));
    }
  }

  /** Calls a node otherwise; a name that another place has already is refused. */
  void rename(long key, String name) {
    if (refused()) {
      return;
    }
    Optional<String> before = tree().find(key).flatMap(node -> Renames.nameOf(node.step()));
    if (before.isEmpty() || before.get().equals(name)) {
      return;
    }
    if (tree().waypoints().containsKey(name) && tree().waypoints().containsKey(before.get())) {
      tell.accept(text("thereIsAPlaceAlready", name));
      return;
    }
    change(text("renameWaypoint", before.get()), Renames.rename(tree(), key, name));
  }

  // --- history

  /** Why nothing can be undone; empty if something can. */
  Optional<String> undoes() {
    return program.flatMap(each -> each.history().undoes());
  }

  Optional<String> redoes() {
    return program.flatMap(each -> each.history().redoes());
  }

  void undo() {
    turn(true);
  }

  void redo() {
    turn(false);
  }

  private void turn(boolean back) {
    Optional<String> what = back ? undoes() : redoes();
    ProgramTree before = tree();
    program
        .flatMap(each -> back ? each.undo() : each.redo())
        .ifPresent(
            key -> {
              tell.accept(
                  text(
                      back ? "undone" : "doneAgain",
                      Language.ofProcess().withinSentence(what.orElse(""))));
              selectChanged(before, key);
            });
  }

  /** Shows people where something has changed. */
  private void selectChanged(ProgramTree before, long key) {
    if (tree().find(key).isPresent()) {
      selection.select(List.of(key));
      return;
    }
    List<Long> come = new ArrayList<>(TreeEdits.keys(tree().nodes()));
    come.removeAll(TreeEdits.keys(before.nodes()));
    if (!come.isEmpty()) {
      selection.select(TreeEdits.keys(TreeEdits.tops(tree(), come)));
    }
  }
}
