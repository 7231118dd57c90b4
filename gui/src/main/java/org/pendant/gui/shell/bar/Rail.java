package org.pendant.gui.shell.bar;

import java.awt.Graphics;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.function.Consumer;
import java.util.function.Function;
import javax.swing.ButtonGroup;
import javax.swing.JPanel;
import javax.swing.JPopupMenu;
import javax.swing.JToggleButton;
import javax.swing.SwingConstants;
import net.miginfocom.swing.MigLayout;
import org.pendant.gui.shell.look.Glyph;
import org.pendant.gui.shell.look.GlyphIcon;
import org.pendant.gui.workbench.Palette;
import org.pendant.gui.workbench.View;

/** The screens, one below the other. */
@SuppressWarnings("serial") // never written to a stream
public final class Rail extends JPanel {
  private final Map<String, JToggleButton> buttons = new LinkedHashMap<>();
  private final ButtonGroup group = new ButtonGroup();
  private final transient Consumer<String> show;
  private final transient Function<String, JPopupMenu> menu;

  /**
   * A rail without screens.
   *
   * @param show brings a view to the front
   * @param menu what else can be done with a view
   */
  public Rail(Consumer<String> show, Function<String, JPopupMenu> menu) {
    super(new MigLayout("insets 8 4 8 4, gap 4, wrap 1", "[fill, 68::]", ""));
    this.show = show;
    this.menu = menu;
    setName("rail");
  }

  /** Adds a screen at the end. */
  public void add(View view, Glyph glyph, String keys) {
    JToggleButton button = new JToggleButton(view.title(), GlyphIcon.of(glyph, 22));
    button.setName("rail-" + view.id());
    button.setVerticalTextPosition(SwingConstants.BOTTOM);
    button.setHorizontalTextPosition(SwingConstants.CENTER);
    button.putClientProperty("JButton.buttonType", "toolBarButton");
    button.putClientProperty("FlatLaf.styleClass", "small");
    button.setToolTipText(view.title() + (keys.isEmpty() ? "" : " (" + keys + ")"));
    button.getAccessibleContext().setAccessibleName(view.title() + " screen");
    button.addActionListener(event -> show.accept(view.id()));
    button.setComponentPopupMenu(menu.apply(view.id()));
    group.add(button);
    buttons.put(view.id(), button);
    add(button, "h 56::");
  }

  /** Marks the screen that is shown; none for an id that is no screen. */
  public void mark(String id) {
    group.clearSelection();
    JToggleButton button = buttons.get(id);
    if (button != null) {
      button.setSelected(true);
    }
  }

  @Override
  protected void paintComponent(Graphics g) {
    super.paintComponent(g);
    g.setColor(Palette.line());
    g.drawLine(getWidth() - 1, 0, getWidth() - 1, getHeight());
  }
}
