package org.pendant.desktop.program;

import static org.pendant.desktop.program.ProgramViewTexts.text;

import com.formdev.flatlaf.util.UIScale;
import java.awt.Dimension;
import java.awt.FontMetrics;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.Point;
import java.awt.Rectangle;
import java.awt.event.MouseEvent;
import java.util.Collection;
import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.OptionalLong;
import java.util.Set;
import java.util.function.Consumer;
import javax.swing.JList;
import javax.swing.KeyStroke;
import javax.swing.ListSelectionModel;
import org.pendant.kit.dock.Dockable;
import org.pendant.project.program.ProgramNode;
import org.pendant.project.program.ProgramTree;
import org.pendant.project.program.check.NodeProblem;

/** Tree list: the nodes of a program, one a line, each below the one that contains it. */
@SuppressWarnings("serial") // never written to a stream
final class TreeList extends JList<TreeRow> {
  private static final int MIN_HEIGHT = 22;
  private static final int MIN_LABEL = 90;

  private final transient TreeRows rows = new TreeRows();
  private final transient TreeCell cell = new TreeCell(new Looks());
  private final transient Set<Long> folded = new HashSet<>();
  private final transient Map<Long, Integer> places = new HashMap<>();
  private transient ProgramTree tree = ProgramTree.empty();
  private transient TreeMarks marks = TreeMarks.NONE;
  private transient TreeMarks shownMarks = TreeMarks.NONE;
  private transient Map<Long, List<NodeProblem>> problems = Map.of();
  private transient Set<Long> found = Set.of();
  private transient NodeLabels labels = NodeLabels.PLAIN;
  private transient Optional<DropSpots.Target> drop = Optional.empty();
  private boolean dropCopies;
  private int digits = 2;
  private int deepest;
  private boolean adjusting;
  private final transient TreeMouse mouse = new TreeMouse(this);
  private transient Consumer<String> refusals = text -> {};
  private transient Runnable chosen = () -> {};

  TreeList() {
    setModel(rows);
    setName("program-tree");
    putClientProperty(Dockable.TAKES_KEYS, true);
    getAccessibleContext().setAccessibleName(text("program"));
    setSelectionMode(ListSelectionModel.MULTIPLE_INTERVAL_SELECTION);
    setCellRenderer(cell);
    addListSelectionListener(
        event -> {
          if (!adjusting && !event.getValueIsAdjusting()) {
            chosen.run();
          }
        });
    freeKeys();
    sizeRows();
  }

  /** Keys that lists take for themselves, and that do something else here. */
  private void freeKeys() {
    for (String keys :
        List.of(
            "ctrl C",
            "ctrl X",
            "ctrl V",
            "ctrl SLASH",
            "meta C",
            "meta X",
            "meta V",
            "COPY",
            "CUT",
            "PASTE",
            "ctrl INSERT",
            "shift INSERT",
            "shift DELETE")) {
      getInputMap(WHEN_FOCUSED).put(KeyStroke.getKeyStroke(keys), "none");
    }
  }

  /** What a mouse does. */
  TreeMouse mouse() {
    return mouse;
  }

  /** Tells why nodes cannot go where the user has dropped them. */
  void onRefusal(Consumer<String> listener) {
    refusals = listener;
  }

  /** Tells when other nodes are selected. */
  void onSelection(Runnable listener) {
    chosen = listener;
  }

  void refuse(String why) {
    refusals.accept(why);
  }

  private void sizeRows() {
    FontMetrics metrics = getFontMetrics(getFont());
    setFixedCellHeight(Math.max(UIScale.scale(MIN_HEIGHT), metrics.getHeight() + UIScale.scale(5)));
    setFixedCellWidth(cell == null ? 1 : cell.textX(deepest) + UIScale.scale(MIN_LABEL));
  }

  @Override
  public void updateUI() {
    super.updateUI();
    if (cell != null) {
      cell.setFont(getFont());
      freeKeys();
      sizeRows();
    }
  }

  @Override
  public boolean getScrollableTracksViewportWidth() {
    return getParent() == null || getParent().getWidth() >= getFixedCellWidth();
  }

  // --- what is shown

  /** Shows a tree; what is selected and folded stays. */
  void show(ProgramTree next) {
    Set<Long> selected = selected();
    OptionalLong lead = lead();
    tree = next;
    List<TreeRow> fresh = TreeRow.of(tree, folded);
    int numbers = 0;
    deepest = 0;
    places.clear();
    for (int i = 0; i < fresh.size(); i++) {
      numbers = Math.max(numbers, fresh.get(i).number());
      deepest = Math.max(deepest, fresh.get(i).depth());
      places.put(fresh.get(i).key(), i);
    }
    digits = String.valueOf(numbers).length();
    adjusting = true;
    cell.setFont(getFont());
    sizeRows();
    rows.show(fresh);
    reselect(selected, lead);
    adjusting = false;
    shownMarks = marks.at(this::visible);
    revalidate();
    repaint();
    if (!selected().equals(selected)) {
      chosen.run();
    }
  }

  /** Where a node is hidden now, the folded one above it is selected in its place. */
  private void reselect(Set<Long> keys, OptionalLong lead) {
    setSelectedIndices(
        keys.stream()
            .map(key -> places.get(visible(key)))
            .filter(Objects::nonNull)
            .mapToInt(Integer::intValue)
            .distinct()
            .toArray());
    if (lead.isPresent() && places.containsKey(visible(lead.getAsLong()))) {
      int place = places.get(visible(lead.getAsLong()));
      getSelectionModel().setAnchorSelectionIndex(place);
      if (isSelectedIndex(place)) {
        addSelectionInterval(place, place);
      }
    }
  }

  ProgramTree tree() {
    return tree;
  }

  void setMarks(TreeMarks wanted) {
    if (!wanted.equals(marks)) {
      marks = wanted;
      shownMarks = marks.at(this::visible);
      repaint();
    }
  }

  void setProblems(Map<Long, List<NodeProblem>> wanted) {
    problems = wanted;
    repaint();
  }

  /** Has nodes called so. */
  void setLabels(NodeLabels wanted) {
    labels = wanted;
    repaint();
  }

  void setFound(Collection<Long> keys) {
    found = Set.copyOf(keys);
    repaint();
  }

  /** The node itself, or the folded one that hides it; 0 if there is none. */
  private long visible(long key) {
    long each = key;
    while (each != ProgramTree.ROOT && !places.containsKey(each)) {
      each = tree.parentOf(each).orElse(ProgramTree.ROOT);
    }
    return each;
  }

  // --- selection

  /** The keys of the selected nodes, in order. */
  Set<Long> selected() {
    Set<Long> keys = new LinkedHashSet<>();
    getSelectedValuesList().forEach(row -> keys.add(row.key()));
    return keys;
  }

  /** The node that was chosen last. */
  OptionalLong lead() {
    int lead = getLeadSelectionIndex();
    if (lead >= 0 && lead < rows.getSize() && isSelectedIndex(lead)) {
      return OptionalLong.of(rows.getElementAt(lead).key());
    }
    int first = getSelectedIndex();
    return first < 0 ? OptionalLong.empty() : OptionalLong.of(rows.getElementAt(first).key());
  }

  /** Selects a node and brings it into view. */
  void select(long key) {
    select(List.of(key));
  }

  /** Selects nodes and brings them into view. */
  void select(Collection<Long> keys) {
    keys.forEach(this::unfoldAbove);
    adjusting = true;
    clearSelection();
    for (long key : keys) {
      Integer place = places.get(key);
      if (place != null) {
        addSelectionInterval(place, place);
      }
    }
    adjusting = false;
    if (!keys.isEmpty()) {
      reveal(keys.iterator().next());
    }
    chosen.run();
  }

  /** Scrolls to a node. */
  void reveal(long key) {
    Integer place = places.get(visible(key));
    if (place != null) {
      Rectangle row = getCellBounds(place, place);
      if (row != null) {
        scrollRectToVisible(new Rectangle(0, row.y, 1, row.height));
      }
    }
  }

  /** The rectangle of a node's text; empty if it is hidden. */
  Optional<Rectangle> textOf(long key) {
    Integer place = places.get(key);
    if (place == null) {
      return Optional.empty();
    }
    Rectangle row = getCellBounds(place, place);
    int x = cell.textX(rows.getElementAt(place).depth());
    return Optional.of(new Rectangle(x, row.y, Math.max(60, row.width - x), row.height));
  }

  // --- folding

  boolean foldable(long key) {
    return !tree.childrenOf(key).isEmpty();
  }

  boolean isFolded(long key) {
    return folded.contains(key);
  }

  void setFolded(long key, boolean wanted) {
    if (foldable(key) && (wanted ? folded.add(key) : folded.remove(key))) {
      show(tree);
    }
  }

  /** Folds all nodes below sections, or unfolds all. */
  void foldAll(boolean wanted) {
    folded.clear();
    if (wanted) {
      tree.sections().stream()
          .flatMap(section -> section.children().stream())
          .forEach(this::foldWithChildren);
    }
    show(tree);
  }

  private void foldWithChildren(ProgramNode node) {
    if (!node.children().isEmpty()) {
      folded.add(node.key());
      node.children().forEach(this::foldWithChildren);
    }
  }

  private void unfoldAbove(long key) {
    boolean changed = false;
    long above = tree.parentOf(key).orElse(ProgramTree.ROOT);
    while (above != ProgramTree.ROOT) {
      changed |= folded.remove(above);
      above = tree.parentOf(above).orElse(ProgramTree.ROOT);
    }
    if (changed) {
      show(tree);
    }
  }

  /** Left: folds the node, or goes to the one above. Right: unfolds it, or goes to the first. */
  void turn(boolean right) {
    lead()
        .ifPresent(
            key -> {
              boolean open = foldable(key) && !isFolded(key);
              if (right && open) {
                select(tree.childrenOf(key).getFirst().key());
              } else if (right) {
                setFolded(key, false);
              } else if (open) {
                setFolded(key, true);
              } else {
                tree.parentOf(key).filter(each -> each != ProgramTree.ROOT).ifPresent(this::select);
              }
            });
  }

  // --- mouse

  /** The row at a point; empty below the last one. */
  Optional<TreeRow> rowAt(Point point) {
    int index = locationToIndex(point);
    return index >= 0 && getCellBounds(index, index).contains(point)
        ? Optional.of(rows.getElementAt(index))
        : Optional.empty();
  }

  @Override
  protected void processMouseEvent(MouseEvent event) {
    boolean taken =
        switch (event.getID()) {
          case MouseEvent.MOUSE_PRESSED -> mouse.pressed(event);
          case MouseEvent.MOUSE_RELEASED -> mouse.released(event);
          default -> false;
        };
    if (!taken) {
      super.processMouseEvent(event);
    }
  }

  @Override
  protected void processMouseMotionEvent(MouseEvent event) {
    if (event.getID() == MouseEvent.MOUSE_DRAGGED) {
      mouse.dragged(event);
    } else {
      super.processMouseMotionEvent(event);
    }
  }

  /** Whether a point is on the arrow that folds a row. */
  boolean onTwisty(TreeRow row, Point point) {
    int begin = cell.twistyX(row.depth());
    return row.hasChildren() && point.x >= begin && point.x < begin + TreeCell.twistyWidth();
  }

  /** A menu opens for what is under the pointer, and before the list hears of the press. */
  @Override
  public Point getPopupLocation(MouseEvent event) {
    if (event != null) {
      requestFocusInWindow();
      rowAt(event.getPoint())
          .filter(row -> !selected().contains(row.key()))
          .ifPresent(row -> select(row.key()));
      return event.getPoint();
    }
    int lead = Math.max(0, getLeadSelectionIndex());
    Rectangle row = getCellBounds(lead, lead);
    return row == null ? new Point() : new Point(row.x + cell.textX(0), row.y + row.height);
  }

  @Override
  public String getToolTipText(MouseEvent event) {
    Optional<TreeRow> row = rowAt(event.getPoint());
    if (row.isEmpty()) {
      return "";
    }
    if (event.getX() < TreeCell.margin()) {
      return shownMarks.execution() == row.get().key() && !shownMarks.note().isEmpty()
          ? shownMarks.note()
          : text("clickToSetOrClearA");
    }
    List<NodeProblem> wrong = problems.getOrDefault(row.get().key(), List.of());
    String label = row.get().label(labels);
    return TreeCell.tip(label, wrong, Optional.ofNullable(shownMarks.notes().get(row.get().key())));
  }

  // --- drops

  /** What a drop at a point would do. */
  Optional<DropSpots.Target> dropAt(Point point, TreeDrag.Cargo cargo) {
    return rows.getSize() == 0
        ? Optional.empty()
        : Optional.of(
            DropSpots.at(
                tree,
                rows.all(),
                point.y / (double) getFixedCellHeight(),
                cell.depthAt(point.x),
                cargo.nodes(),
                cargo.moved()));
  }

  /** Draws where a drop would go. */
  void showDrop(Optional<DropSpots.Target> target, boolean copied) {
    drop = target;
    dropCopies = copied;
    repaint();
  }

  Optional<DropSpots.Target> drop() {
    return drop;
  }

  /** Where the drawing of a row of a depth begins, from the left. */
  int contentX(int depth) {
    return cell.twistyX(depth) + TreeCell.twistyWidth();
  }

  @Override
  protected void paintComponent(Graphics g) {
    super.paintComponent(g);
    drop.ifPresent(target -> new DropMark(this, target, dropCopies).paint((Graphics2D) g.create()));
  }

  /** As wide as it needs, as high as the rows. */
  @Override
  public Dimension getPreferredScrollableViewportSize() {
    return new Dimension(getFixedCellWidth(), 12 * getFixedCellHeight());
  }

  /** What the cells ask for. */
  private final class Looks implements TreeCell.TreeLooks {
    @Override
    public TreeMarks marks() {
      return shownMarks;
    }

    @Override
    public int digits() {
      return digits;
    }

    @Override
    public List<NodeProblem> problems(long key) {
      return problems.getOrDefault(key, List.of());
    }

    @Override
    public boolean found(long key) {
      return found.contains(key);
    }

    @Override
    public String label(TreeRow row) {
      return row.label(labels);
    }
  }
}
