package org.pendant.desktop.plot;

import static org.pendant.desktop.plot.PlotTexts.text;

import java.awt.BorderLayout;
import java.awt.Component;
import java.awt.Dimension;
import java.awt.Rectangle;
import java.awt.event.ActionEvent;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.function.BiConsumer;
import java.util.function.Consumer;
import javax.swing.AbstractAction;
import javax.swing.BorderFactory;
import javax.swing.JComponent;
import javax.swing.JPanel;
import javax.swing.JScrollPane;
import javax.swing.JTextField;
import javax.swing.JTree;
import javax.swing.KeyStroke;
import javax.swing.tree.DefaultMutableTreeNode;
import javax.swing.tree.DefaultTreeCellRenderer;
import javax.swing.tree.DefaultTreeModel;
import javax.swing.tree.TreePath;
import net.miginfocom.swing.MigLayout;
import org.pendant.kit.layout.Typed;
import org.pendant.kit.text.Messages;
import org.pendant.kit.theme.Markup;

/** Quantity tree: the list of what can be drawn, with a search above it. */
final class QuantityTree {
  /** Groups whose parts are in sight before one is opened; all would be a hundred rows. */
  private static final Set<String> OPEN_AT_FIRST =
      Set.of(
          ScriptVariables.GROUP,
          Messages.shown(ChartQuantities.JOINTS),
          Messages.shown(ChartQuantities.TCP));

  private final ChartQuantities quantities;
  private final Consumer<List<ChartQuantity>> chosen;
  private final JPanel content = new JPanel(new BorderLayout());
  private final JTextField search = new JTextField();
  private final JTree tree = new Quantities();

  /**
   * The list.
   *
   * @param chosen takes what was double-clicked or entered
   */
  QuantityTree(ChartQuantities quantities, Consumer<List<ChartQuantity>> chosen) {
    this.quantities = quantities;
    this.chosen = chosen;
    buildSearch();
    buildTree();
    JPanel head = new JPanel(new MigLayout("insets 8", "[grow,fill]"));
    head.add(search);
    JScrollPane scroll = new JScrollPane(tree);
    scroll.setBorder(BorderFactory.createEmptyBorder());
    content.add(head, BorderLayout.NORTH);
    content.add(scroll, BorderLayout.CENTER);
    content.setMinimumSize(new Dimension(0, 0));
    int width = content.getFontMetrics(content.getFont()).charWidth('m') * 20;
    content.setPreferredSize(new Dimension(width, 0));
    fill();
  }

  private void buildSearch() {
    search.setName("plot-search");
    search.putClientProperty("JTextField.placeholderText", text("searchQuantities"));
    search.putClientProperty("JTextField.showClearButton", true);
    search.setToolTipText(text("searchQuantitiesEnterDrawsWhatIs"));
    search.getAccessibleContext().setAccessibleName(text("searchQuantities"));
    search.getDocument().addDocumentListener(new Typed(this::fill));
    search.addActionListener(
        event -> quantities.search(search.getText()).stream().limit(1).forEach(this::choose));
  }

  private void choose(ChartQuantity quantity) {
    chosen.accept(List.of(quantity));
  }

  private void buildTree() {
    tree.setName("plot-quantities");
    tree.setRootVisible(false);
    tree.setShowsRootHandles(true);
    tree.setToggleClickCount(1);
    tree.setToolTipText(text("doubleClickPressEnterOrDrag"));
    tree.getAccessibleContext().setAccessibleName(text("quantities"));
    tree.setCellRenderer(new Names());
    tree.setDragEnabled(true);
    tree.setTransferHandler(QuantityTransfer.from(quantities, this::selected));
    tree.getInputMap().put(KeyStroke.getKeyStroke("ENTER"), "plot-add");
    tree.getActionMap().put("plot-add", new Adding());
    tree.addMouseListener(
        new MouseAdapter() {
          @Override
          public void mouseClicked(MouseEvent event) {
            TreePath path = tree.getPathForLocation(event.getX(), event.getY());
            if (event.getClickCount() == 2 && path != null) {
              addAllOf(List.of(path));
            }
          }
        });
  }

  JComponent component() {
    return content;
  }

  void focusSearch() {
    search.requestFocusInWindow();
    search.selectAll();
  }

  /** Shows quantities that have come and gone; what is open stays open. */
  void refill() {
    Set<String> open = new HashSet<>();
    Set<String> closed = new HashSet<>();
    eachGroup((name, path) -> (tree.isExpanded(path) ? open : closed).add(name));
    List<String> chosenIds = selected().stream().map(ChartQuantity::id).toList();
    fill();
    eachGroup(
        (name, path) -> {
          if (open.contains(name)) {
            tree.expandPath(path);
          } else if (closed.contains(name)) {
            tree.collapsePath(path);
          }
        });
    for (int row = 0; row < tree.getRowCount(); row++) {
      TreePath path = tree.getPathForRow(row);
      if (isLeaf(path) && chosenIds.contains(quantitiesOf(List.of(path)).getFirst().id())) {
        tree.addSelectionPath(path);
      }
    }
  }

  /** Every group in sight with its place; rows that come to be in sight are visited too. */
  private void eachGroup(BiConsumer<String, TreePath> visitor) {
    for (int row = 0; row < tree.getRowCount(); row++) {
      TreePath path = tree.getPathForRow(row);
      if (!isLeaf(path)) {
        visitor.accept(path.toString(), path);
      }
    }
  }

  private void fill() {
    DefaultMutableTreeNode root = new DefaultMutableTreeNode();
    Map<String, DefaultMutableTreeNode> groups = new HashMap<>();
    for (ChartQuantity each : quantities.search(search.getText())) {
      group(root, groups, each.group()).add(new DefaultMutableTreeNode(each, false));
    }
    tree.setModel(new DefaultTreeModel(root));
    boolean searching = !search.getText().isBlank();
    for (int row = 0; row < tree.getRowCount(); row++) {
      TreePath path = tree.getPathForRow(row);
      if (searching || OPEN_AT_FIRST.contains(path.getLastPathComponent().toString())) {
        tree.expandPath(path);
      }
    }
  }

  private static DefaultMutableTreeNode group(
      DefaultMutableTreeNode root, Map<String, DefaultMutableTreeNode> groups, String path) {
    DefaultMutableTreeNode present = groups.get(path);
    if (present != null) {
      return present;
    }
    int slash = path.lastIndexOf('/');
    DefaultMutableTreeNode above = slash < 0 ? root : group(root, groups, path.substring(0, slash));
    DefaultMutableTreeNode added = new DefaultMutableTreeNode(path.substring(slash + 1));
    above.add(added);
    groups.put(path, added);
    return added;
  }

  private List<ChartQuantity> selected() {
    TreePath[] paths = tree.getSelectionPaths();
    return paths == null ? List.of() : quantitiesOf(List.of(paths));
  }

  /** The quantities at these places; a group stands for all in it if nothing is below it. */
  private static List<ChartQuantity> quantitiesOf(List<TreePath> paths) {
    List<ChartQuantity> found = new ArrayList<>();
    for (TreePath path : paths) {
      DefaultMutableTreeNode node = (DefaultMutableTreeNode) path.getLastPathComponent();
      if (node.getUserObject() instanceof ChartQuantity quantity) {
        found.add(quantity);
      } else {
        for (int i = 0; i < node.getChildCount(); i++) {
          DefaultMutableTreeNode below = (DefaultMutableTreeNode) node.getChildAt(i);
          if (below.getUserObject() instanceof ChartQuantity quantity) {
            found.add(quantity);
          }
        }
      }
    }
    return found;
  }

  private void addAllOf(List<TreePath> paths) {
    List<ChartQuantity> found =
        paths.stream()
            .filter(path -> isLeaf(path) || paths.size() > 1)
            .flatMap(path -> quantitiesOf(List.of(path)).stream())
            .toList();
    if (!found.isEmpty()) {
      chosen.accept(found);
    }
  }

  private static boolean isLeaf(TreePath path) {
    return ((DefaultMutableTreeNode) path.getLastPathComponent()).getUserObject()
        instanceof ChartQuantity;
  }

  @SuppressWarnings("serial") // never written to a stream
  private final class Adding extends AbstractAction {
    @Override
    public void actionPerformed(ActionEvent event) {
      List<ChartQuantity> found = selected();
      if (!found.isEmpty()) {
        chosen.accept(found);
      }
    }
  }

  /** The tree: what is cut at its right edge has all its words in the tool tip. */
  @SuppressWarnings("serial") // never written to a stream
  private static final class Quantities extends JTree {
    Quantities() {
      super(new DefaultMutableTreeNode());
    }

    @Override
    public String getToolTipText(MouseEvent event) {
      String tip = super.getToolTipText(event);
      TreePath path = getPathForLocation(event.getX(), event.getY());
      if (path == null || inSight(getPathBounds(path))) {
        return tip;
      }
      String title = title(path.getLastPathComponent());
      String hint = hint(path.getLastPathComponent());
      return Markup.toolTip(hint.isEmpty() ? title : title + "\n" + hint);
    }

    private boolean inSight(Rectangle row) {
      Rectangle sight = getVisibleRect();
      return row.x >= sight.x && row.x + row.width <= sight.x + sight.width;
    }
  }

  private static String title(Object node) {
    if (((DefaultMutableTreeNode) node).getUserObject() instanceof ChartQuantity quantity) {
      boolean plain = quantity.unit().isEmpty() || quantity.digital();
      String title = quantity.namedTitle();
      return plain ? title : title + " (" + quantity.unit() + ")";
    }
    return String.valueOf(node);
  }

  /** What more there is to say; empty for nothing. */
  private static String hint(Object node) {
    return ((DefaultMutableTreeNode) node).getUserObject() instanceof ChartQuantity quantity
        ? quantity.hint()
        : "";
  }

  /** Titles, with the units of quantities. */
  @SuppressWarnings("serial") // never written to a stream
  private static final class Names extends DefaultTreeCellRenderer {
    @Override
    public Component getTreeCellRendererComponent(
        JTree of,
        Object value,
        boolean isSelected,
        boolean expanded,
        boolean leaf,
        int row,
        boolean focused) {
      super.getTreeCellRendererComponent(of, value, isSelected, expanded, leaf, row, focused);
      setIcon(null);
      setText(title(value));
      String hint = hint(value);
      setToolTipText(hint.isEmpty() ? null : hint);
      return this;
    }
  }
}
