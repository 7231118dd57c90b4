package org.pendant.desktop.editor;

import static org.pendant.desktop.editor.EditorTexts.text;

import java.awt.BorderLayout;
import java.awt.Component;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.util.List;
import java.util.Optional;
import javax.swing.JComponent;
import javax.swing.JPanel;
import javax.swing.JScrollPane;
import javax.swing.JTree;
import javax.swing.KeyStroke;
import javax.swing.SwingUtilities;
import javax.swing.tree.DefaultMutableTreeNode;
import javax.swing.tree.DefaultTreeCellRenderer;
import javax.swing.tree.DefaultTreeModel;
import javax.swing.tree.TreeModel;
import javax.swing.tree.TreePath;
import javax.swing.tree.TreeSelectionModel;
import org.pendant.desktop.editor.text.AnalysedText;
import org.pendant.desktop.workbench.View;
import org.pendant.desktop.workbench.Workbench;
import org.pendant.language.service.OutlineItem;
import org.pendant.language.source.ByteText;

/**
 * Outline view: the definitions and globals of the program in front; the selection follows the
 * caret.
 */
public final class OutlineView implements View {
  /** Its name in settings and commands. */
  public static final String ID = "outline";

  /** What people read on its tab. */
  public static final String TITLE = text("outline");

  private final Workbench workbench;
  private final ScriptEditor editor;
  private final DefaultTreeModel model = new DefaultTreeModel(new DefaultMutableTreeNode());
  private final JTree tree = new ItemTree(model);
  private final EmptyState states = new EmptyState(new JScrollPane(tree));
  private final JPanel content = new JPanel(new BorderLayout());
  private List<OutlineItem> shown = List.of();

  /** The very list that was looked at last; comparing it with itself costs nothing. */
  private List<OutlineItem> seen = List.of();

  /** The outline of what {@code editor} has in front. */
  public OutlineView(Workbench workbench, ScriptEditor editor) {
    this.workbench = workbench;
    this.editor = editor;
    content.setName("outline-panel");
    content.add(states);
    tree.setName("outline-tree");
    tree.getAccessibleContext().setAccessibleName(text("outline"));
    tree.setToolTipText(text("enterOrAClickGoesTo"));
    tree.setRootVisible(false);
    tree.setShowsRootHandles(true);
    tree.setToggleClickCount(0);
    tree.getSelectionModel().setSelectionMode(TreeSelectionModel.SINGLE_TREE_SELECTION);
    tree.setCellRenderer(new ItemCell());
    tree.registerKeyboardAction(
        event -> go(), KeyStroke.getKeyStroke("ENTER"), JComponent.WHEN_FOCUSED);
    tree.addMouseListener(
        new MouseAdapter() {
          @Override
          public void mouseClicked(MouseEvent event) {
            if (SwingUtilities.isLeftMouseButton(event)
                && tree.getPathForLocation(event.getX(), event.getY()) != null) {
              go();
            }
          }
        });
    editor.addListener(this::follow);
    states.showNote(text("functionsThreadsAndGlobalsAppearHere"));
    follow();
  }

  @Override
  public String id() {
    return ID;
  }

  @Override
  public String title() {
    return TITLE;
  }

  @Override
  public JComponent component() {
    return content;
  }

  /** Shows the newest analysis and selects what the caret stands in. */
  private void follow() {
    editor
        .current()
        .analysed()
        .ifPresent(
            analysed -> {
              if (!analysed.outline().equals(seen) && !analysed.outline().equals(shown)) {
                boolean same = sameShape(shown, analysed.outline());
                shown = analysed.outline();
                if (same) {
                  refill((DefaultMutableTreeNode) model.getRoot(), shown);
                } else {
                  fill();
                }
              }
              seen = analysed.outline();
              if (!tree.hasFocus()) {
                select(analysed);
              }
            });
  }

  /** Whether only places have changed: the usual case while the user types. */
  private static boolean sameShape(List<OutlineItem> some, List<OutlineItem> others) {
    if (some.size() != others.size()) {
      return false;
    }
    for (int i = 0; i < some.size(); i++) {
      OutlineItem one = some.get(i);
      OutlineItem other = others.get(i);
      if (one.kind() != other.kind()
          || !one.name().equals(other.name())
          || !one.detail().equals(other.detail())
          || !sameShape(one.children(), other.children())) {
        return false;
      }
    }
    return true;
  }

  private static void refill(DefaultMutableTreeNode node, List<OutlineItem> items) {
    for (int i = 0; i < items.size(); i++) {
      DefaultMutableTreeNode child = (DefaultMutableTreeNode) node.getChildAt(i);
      child.setUserObject(items.get(i));
      refill(child, items.get(i).children());
    }
  }

  private void fill() {
    DefaultMutableTreeNode root = new DefaultMutableTreeNode();
    shown.forEach(item -> root.add(node(item)));
    model.setRoot(root);
    for (int row = 0; row < tree.getRowCount(); row++) {
      tree.expandRow(row);
    }
    if (shown.isEmpty()) {
      states.showNote(text("thisProgramDefinesNothingYet"));
    } else {
      states.showContent();
    }
  }

  private static DefaultMutableTreeNode node(OutlineItem item) {
    DefaultMutableTreeNode node = new DefaultMutableTreeNode(item);
    item.children().forEach(child -> node.add(node(child)));
    return node;
  }

  private void select(AnalysedText analysed) {
    int offset = analysed.toByte(editor.current().area().getCaretPosition());
    DefaultMutableTreeNode found = (DefaultMutableTreeNode) model.getRoot();
    boolean deeper = true;
    while (deeper) {
      Optional<DefaultMutableTreeNode> child = childAt(found, offset);
      deeper = child.isPresent();
      found = child.orElse(found);
    }
    if (found.getParent() == null) {
      tree.clearSelection();
    } else {
      TreePath path = new TreePath(found.getPath());
      tree.setSelectionPath(path);
      tree.scrollPathToVisible(path);
    }
  }

  private static Optional<DefaultMutableTreeNode> childAt(DefaultMutableTreeNode node, int offset) {
    for (int i = 0; i < node.getChildCount(); i++) {
      DefaultMutableTreeNode child = (DefaultMutableTreeNode) node.getChildAt(i);
      OutlineItem item = (OutlineItem) child.getUserObject();
      if (item.range().start() <= offset && offset <= item.range().end()) {
        return Optional.of(child);
      }
    }
    return Optional.empty();
  }

  private void go() {
    if (tree.getLastSelectedPathComponent() instanceof DefaultMutableTreeNode node
        && node.getUserObject() instanceof OutlineItem item) {
      ProgramEditor program = editor.current();
      workbench.show(ScriptEditor.ID);
      program.analysed().ifPresent(now -> program.jump(now.span(item.nameRange())));
    }
  }

  /** Items by the text that people read: that of all of an item, with what is in it, is long. */
  @SuppressWarnings("serial") // never written to a stream
  private static final class ItemTree extends JTree {
    ItemTree(TreeModel model) {
      super(model);
    }

    @Override
    public String convertValueToText(
        Object value, boolean selected, boolean expanded, boolean leaf, int row, boolean focused) {
      return value instanceof DefaultMutableTreeNode node
              && node.getUserObject() instanceof OutlineItem item
          ? ByteText.decoded(item.name() + item.detail())
          : "";
    }
  }

  /** Kind, name and parameters. */
  @SuppressWarnings("serial") // never written to a stream
  private static final class ItemCell extends DefaultTreeCellRenderer {
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
      if (value instanceof DefaultMutableTreeNode node
          && node.getUserObject() instanceof OutlineItem item) {
        setIcon(KindIcon.of(item.kind()));
      }
      return this;
    }
  }
}
