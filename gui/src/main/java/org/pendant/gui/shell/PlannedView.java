package org.pendant.gui.shell;

import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JPanel;
import net.miginfocom.swing.MigLayout;
import org.pendant.controller.state.ControllerState;
import org.pendant.gui.workbench.Palette;
import org.pendant.gui.workbench.View;

/** Stands where a view will be. */
final class PlannedView implements View {
  private final String id;
  private final String title;
  private final JLabel text;
  private final JPanel panel =
      new JPanel(new MigLayout("fill, insets 16, wrap 1", "[center]", "push[]4[]push"));

  PlannedView(String id, String title, String coming) {
    this.id = id;
    this.title = title;
    JLabel heading = new JLabel(title);
    heading.putClientProperty("FlatLaf.styleClass", "h3");
    text = new JLabel("<html><center>" + coming + "</center></html>");
    panel.setName(id + "-planned");
    panel.getAccessibleContext().setAccessibleName(title);
    panel.add(heading);
    panel.add(text, "wmin 0");
  }

  @Override
  public String id() {
    return id;
  }

  @Override
  public String title() {
    return title;
  }

  @Override
  public JComponent component() {
    return panel;
  }

  @Override
  public void refresh(ControllerState state) {
    text.setForeground(Palette.quiet());
  }
}
