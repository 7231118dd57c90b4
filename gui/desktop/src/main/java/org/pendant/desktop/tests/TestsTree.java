package org.pendant.desktop.tests;

import static org.pendant.desktop.tests.TestsTexts.text;

import com.formdev.flatlaf.util.UIScale;
import java.awt.Color;
import java.awt.Component;
import java.awt.event.MouseEvent;
import java.util.ArrayList;
import java.util.Enumeration;
import java.util.HashSet;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import javax.swing.Icon;
import javax.swing.JTree;
import javax.swing.tree.DefaultMutableTreeNode;
import javax.swing.tree.DefaultTreeCellRenderer;
import javax.swing.tree.DefaultTreeModel;
import javax.swing.tree.TreePath;
import org.pendant.kit.icon.Glyph;
import org.pendant.kit.theme.Palette;
import org.pendant.testing.TestId;
import org.pendant.testing.coverage.CoverageReport;
import org.pendant.testing.source.TestCase;

/** Tests tree: files and the tests in them, and below what these have reached of programs. */
@SuppressWarnings("serial") // never written to a stream
final class TestsTree extends JTree {
  private static final int ROW = 24;
  private static final int ICON = 16;

  private final TestsPresenter presenter;
  private final DefaultMutableTreeNode root = new DefaultMutableTreeNode("tests");
  private final DefaultTreeModel model = new DefaultTreeModel(root);
  private List<FoundFile> shown = List.of();
  private Optional<CoverageReport> covered = Optional.empty();

  TestsTree(TestsPresenter presenter) {
    this.presenter = presenter;
    setName("tests-tree");
    getAccessibleContext().setAccessibleName(text("tests"));
    setModel(model);
    setRootVisible(false);
    setShowsRootHandles(true);
    // sizes are asked for whenever a row is painted: they change with every result
    setLargeModel(true);
    setToggleClickCount(0);
    setCellRenderer(new Cell());
  }

  @Override
  public void updateUI() {
    super.updateUI();
    setRowHeight(UIScale.scale(ROW));
  }

  /** Shows what has changed. */
  void refresh() {
    if (!presenter.files().equals(shown) || !presenter.coverage().equals(covered)) {
      rebuild();
    }
    treeDidChange();
    repaint();
  }

  private void rebuild() {
    Set<String> folded = new HashSet<>();
    for (int i = 0; i < root.getChildCount(); i++) {
      DefaultMutableTreeNode each = (DefaultMutableTreeNode) root.getChildAt(i);
      if (!isExpanded(new TreePath(each.getPath())) && each.getChildCount() > 0) {
        folded.add(key(each.getUserObject()));
      }
    }
    Set<String> selected = new HashSet<>();
    chosen().forEach(each -> selected.add(key(each)));
    shown = presenter.files();
    root.removeAllChildren();
    for (FoundFile file : shown) {
      DefaultMutableTreeNode node = new DefaultMutableTreeNode(file);
      file.tests().forEach(each -> node.add(new DefaultMutableTreeNode(each)));
      root.add(node);
    }
    covered = presenter.coverage();
    covered.ifPresent(
        report -> {
          DefaultMutableTreeNode node = new DefaultMutableTreeNode(report);
          CoveredFile.of(report).forEach(each -> node.add(new DefaultMutableTreeNode(each)));
          root.add(node);
        });
    model.reload();
    List<TreePath> again = new ArrayList<>();
    for (Enumeration<?> all = root.preorderEnumeration(); all.hasMoreElements(); ) {
      DefaultMutableTreeNode node = (DefaultMutableTreeNode) all.nextElement();
      TreePath path = new TreePath(node.getPath());
      if (node.getLevel() == 1 && !folded.contains(key(node.getUserObject()))) {
        expandPath(path);
      }
      if (selected.contains(key(node.getUserObject()))) {
        again.add(path);
      }
    }
    setSelectionPaths(again.toArray(TreePath[]::new));
  }

  private static String key(Object node) {
    return switch (node) {
      case FoundFile file -> file.name();
      case TestCase test -> test.id().file() + ":" + test.id().name();
      case CoverageReport _ -> "coverage";
      case CoveredFile file -> "coverage:" + file.name();
      default -> "";
    };
  }

  /** What is selected: files and tests. */
  private List<Object> chosen() {
    List<Object> found = new ArrayList<>();
    TreePath[] paths = getSelectionPaths();
    if (paths != null) {
      for (TreePath each : paths) {
        found.add(((DefaultMutableTreeNode) each.getLastPathComponent()).getUserObject());
      }
    }
    return found;
  }

  /** The tests that are selected, by themselves or with their file. */
  Set<TestId> chosenTests() {
    Set<TestId> ids = new LinkedHashSet<>();
    for (Object each : chosen()) {
      switch (each) {
        case FoundFile file -> file.tests().forEach(test -> ids.add(test.id()));
        case TestCase test -> ids.add(test.id());
        default -> {}
      }
    }
    return ids;
  }

  /** The test or the file that keys go to. */
  Optional<Object> front() {
    // the tree's own lead follows only when all have been told of a selection
    return Optional.ofNullable(getSelectionModel().getLeadSelectionPath())
        .filter(this::isPathSelected)
        .map(each -> ((DefaultMutableTreeNode) each.getLastPathComponent()).getUserObject());
  }

  /** The test that keys go to. */
  Optional<TestCase> selectedTest() {
    return front().filter(TestCase.class::isInstance).map(TestCase.class::cast);
  }

  /** Selects a test and brings it in sight. */
  void choose(TestId id) {
    for (Enumeration<?> all = root.preorderEnumeration(); all.hasMoreElements(); ) {
      DefaultMutableTreeNode node = (DefaultMutableTreeNode) all.nextElement();
      if (node.getUserObject() instanceof TestCase test && test.id().equals(id)) {
        TreePath path = new TreePath(node.getPath());
        setSelectionPath(path);
        scrollPathToVisible(path);
      }
    }
  }

  /** Selects what a mouse is on, unless it is selected. */
  void chooseAt(MouseEvent event) {
    TreePath path = getPathForLocation(event.getX(), event.getY());
    if (path != null && !isPathSelected(path)) {
      setSelectionPath(path);
    }
  }

  /** Whether a mouse is on a row. */
  boolean onRow(MouseEvent event) {
    return getPathForLocation(event.getX(), event.getY()) != null;
  }

  @Override
  public String convertValueToText(
      Object value, boolean selected, boolean expanded, boolean leaf, int row, boolean focused) {
    return switch (((DefaultMutableTreeNode) value).getUserObject()) {
      case FoundFile file -> TestWords.row(presenter, file);
      case TestCase test -> TestWords.row(presenter, test);
      case CoverageReport report -> CoverageWords.row(report);
      case CoveredFile file -> CoverageWords.row(file);
      default -> "";
    };
  }

  private TestMark mark(Object node) {
    return switch (node) {
      case FoundFile file -> presenter.mark(file);
      case TestCase test -> presenter.mark(test.id());
      default -> TestMark.NEW;
    };
  }

  /** In the colour of the mark; in that of the text where the row is selected, to be seen there. */
  private static Icon icon(TestMark mark, boolean selected) {
    Glyph glyph =
        switch (mark) {
          case NEW -> Glyph.RING;
          case WAITING -> Glyph.MORE;
          case PASSED -> Glyph.CHECK;
          case RED -> Glyph.CROSS;
          case SKIPPED -> Glyph.SKIP;
        };
    return selected ? glyph.icon(ICON) : glyph.icon(ICON, color(mark));
  }

  private static Color color(TestMark mark) {
    return switch (mark) {
      case NEW, SKIPPED -> Palette.quiet();
      case WAITING -> Palette.accent();
      case PASSED -> Palette.ok();
      case RED -> Palette.error();
    };
  }

  private final class Cell extends DefaultTreeCellRenderer {
    @Override
    public Component getTreeCellRendererComponent(
        JTree tree,
        Object value,
        boolean selected,
        boolean expanded,
        boolean leaf,
        int row,
        boolean focused) {
      super.getTreeCellRendererComponent(tree, value, selected, expanded, leaf, row, focused);
      Object node = ((DefaultMutableTreeNode) value).getUserObject();
      if (node instanceof CoverageReport || node instanceof CoveredFile) {
        setIcon(selected ? Glyph.PLOT.icon(ICON) : Glyph.PLOT.icon(ICON, Palette.quiet()));
        getAccessibleContext().setAccessibleName(getText());
      } else {
        TestMark mark = mark(node);
        setIcon(icon(mark, selected));
        getAccessibleContext().setAccessibleName(getText() + ", " + TestWords.of(mark));
      }
      return this;
    }

    @Override
    public Color getBackgroundNonSelectionColor() {
      return null;
    }
  }
}
