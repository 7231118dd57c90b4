package org.pendant.desktop.shell.chrome;

import static org.pendant.desktop.shell.chrome.ChromeTexts.text;

import com.formdev.flatlaf.util.UIScale;
import java.awt.Container;
import java.awt.Dimension;
import java.awt.Graphics;
import java.awt.LayoutManager;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Consumer;
import java.util.function.Function;
import javax.swing.ButtonGroup;
import javax.swing.JButton;
import javax.swing.JMenuItem;
import javax.swing.JPanel;
import javax.swing.JPopupMenu;
import javax.swing.JRadioButtonMenuItem;
import javax.swing.JToggleButton;
import javax.swing.SwingConstants;
import org.pendant.desktop.workbench.View;
import org.pendant.kit.action.ActionTable;
import org.pendant.kit.action.KeyText;
import org.pendant.kit.icon.Glyph;
import org.pendant.kit.theme.Palette;

/**
 * Rail: the screens, one below the other. In a low window they lose their words; those that have no
 * room then are in a menu at the end.
 */
@SuppressWarnings("serial") // never written to a stream
public final class Rail extends JPanel {
  /** Least height of a button with and without its word, in pixels before scaling. */
  private static final int WORDED = 56;

  private static final int WORDLESS = 38;
  private static final int GAP = 4;
  private static final int WIDTH = 86;

  private final Map<String, Screen> screens = new LinkedHashMap<>();
  private final ButtonGroup group = new ButtonGroup();
  private final JButton more = new JButton(Glyph.MORE.icon(22));
  private final transient ActionTable actions;
  private final transient Consumer<String> show;
  private final transient Function<String, JPopupMenu> menu;

  /** A screen and its button. */
  private record Screen(View view, JToggleButton button) {}

  /**
   * A rail without screens.
   *
   * @param actions the one of {@code view.} and a screen's id shows it by key
   * @param show brings a view to the front
   * @param menu what else can be done with a view
   */
  public Rail(ActionTable actions, Consumer<String> show, Function<String, JPopupMenu> menu) {
    this.actions = actions;
    this.show = show;
    this.menu = menu;
    setName("rail");
    setLayout(new Stack());
    more.setName("rail-more");
    more.setToolTipText(text("moreScreens"));
    more.getAccessibleContext().setAccessibleName(text("moreScreens"));
    more.putClientProperty("JButton.buttonType", "toolBarButton");
    more.addActionListener(event -> hidden().show(more, more.getWidth(), 0));
    add(more);
    actions.addListener(this::showKeys);
  }

  /** Adds a screen at the end. */
  public void add(View view, Glyph glyph) {
    JToggleButton button = new JToggleButton(view.title(), glyph.icon(22));
    button.setName("rail-" + view.id());
    button.setVerticalTextPosition(SwingConstants.BOTTOM);
    button.setHorizontalTextPosition(SwingConstants.CENTER);
    button.putClientProperty("JButton.buttonType", "toolBarButton");
    button.putClientProperty("FlatLaf.styleClass", "small");
    button.getAccessibleContext().setAccessibleName(text("screen", view.title()));
    button.addActionListener(event -> show.accept(view.id()));
    button.setComponentPopupMenu(menu.apply(view.id()));
    group.add(button);
    screens.put(view.id(), new Screen(view, button));
    add(button, getComponentCount() - 1);
    showKeys();
  }

  private void showKeys() {
    for (Screen each : screens.values()) {
      String keys = KeyText.shown(actions.keysOf("view." + each.view().id()));
      each.button().setToolTipText(each.view().title() + (keys.isEmpty() ? "" : " (" + keys + ")"));
    }
  }

  /** Marks the screen that is shown; none for an id that is no screen. */
  public void mark(String id) {
    group.clearSelection();
    Screen screen = screens.get(id);
    if (screen != null) {
      screen.button().setSelected(true);
    }
  }

  /** The screens that have no button now. */
  private JPopupMenu hidden() {
    JPopupMenu popup = new JPopupMenu();
    popup.setName("rail-menu");
    for (Screen each : screens.values()) {
      if (!each.button().isVisible()) {
        JMenuItem item = new JRadioButtonMenuItem(each.view().title(), each.button().isSelected());
        item.addActionListener(event -> show.accept(each.view().id()));
        popup.add(item);
      }
    }
    return popup;
  }

  @Override
  protected void paintComponent(Graphics g) {
    super.paintComponent(g);
    g.setColor(Palette.line());
    g.drawLine(getWidth() - 1, 0, getWidth() - 1, getHeight());
  }

  /** Buttons below each other, as the height allows. */
  private final class Stack implements LayoutManager {
    @Override
    public void layoutContainer(Container parent) {
      List<Screen> all = new ArrayList<>(screens.values());
      int gap = UIScale.scale(GAP);
      int room = getHeight() - 2 * gap;
      boolean worded = height(WORDED) * all.size() <= room;
      int height = height(worded ? WORDED : WORDLESS);
      int fitting = room / height;
      int shown = fitting >= all.size() ? all.size() : Math.max(0, fitting - 1);
      int y = gap;
      for (int i = 0; i < all.size(); i++) {
        JToggleButton button = all.get(i).button();
        button.setText(worded ? all.get(i).view().title() : "");
        button.setVisible(i < shown);
        button.setBounds(gap, y, getWidth() - 2 * gap, height - gap);
        y += i < shown ? height : 0;
      }
      more.setVisible(shown < all.size());
      more.setBounds(gap, y, getWidth() - 2 * gap, height - gap);
    }

    /** Height of a button of {@code least} pixels before scaling, with the gap below it. */
    private int height(int least) {
      int text = getFontMetrics(getFont()).getHeight();
      int needed = least == WORDED ? UIScale.scale(34) + text : 0;
      return Math.max(UIScale.scale(least), needed) + UIScale.scale(GAP);
    }

    @Override
    public Dimension preferredLayoutSize(Container parent) {
      return new Dimension(UIScale.scale(WIDTH), screens.size() * height(WORDED));
    }

    @Override
    public Dimension minimumLayoutSize(Container parent) {
      return new Dimension(UIScale.scale(WIDTH), height(WORDLESS));
    }

    @Override
    public void addLayoutComponent(String name, java.awt.Component component) {}

    @Override
    public void removeLayoutComponent(java.awt.Component component) {}
  }
}
