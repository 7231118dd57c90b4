package org.pendant.kit.theme;

import java.awt.Color;
import java.awt.event.ComponentAdapter;
import java.awt.event.ComponentEvent;
import javax.swing.BorderFactory;
import javax.swing.JTextArea;
import javax.swing.UIManager;

/** A text that breaks its lines where it has to, and that can be selected and copied. */
@SuppressWarnings("serial") // never written to a stream
public final class WrappedText extends JTextArea {

  /**
   * A text.
   *
   * @param meaning what it is, for screen readers
   */
  public WrappedText(String text, String meaning) {
    super(text);
    setEditable(false);
    setLineWrap(true);
    setWrapStyleWord(true);
    getAccessibleContext().setAccessibleName(meaning);
    addComponentListener(
        new ComponentAdapter() {
          @Override
          public void componentResized(ComponentEvent event) {
            // Its height depends on its width, which is known only now.
            if (getPreferredSize().height != getHeight()) {
              revalidate();
            }
          }
        });
  }

  @Override
  public void updateUI() {
    super.updateUI();
    setBorder(BorderFactory.createEmptyBorder());
    setFont(UIManager.getFont("Label.font"));
    setOpaque(false);
  }

  @Override
  public Color getForeground() {
    Color label = UIManager.getColor("Label.foreground");
    return label == null ? super.getForeground() : label;
  }
}
