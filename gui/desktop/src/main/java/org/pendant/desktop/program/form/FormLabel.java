package org.pendant.desktop.program.form;

import java.awt.Dimension;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JTextField;

/** Form label: what stands beside a field, as high as one. */
@SuppressWarnings("serial") // never written to a stream
final class FormLabel extends JLabel {
  FormLabel(String text, JComponent field) {
    super(text);
    setLabelFor(field);
    setToolTipText(text);
  }

  @Override
  public Dimension getPreferredSize() {
    Dimension own = super.getPreferredSize();
    return new Dimension(
        own.width, Math.max(own.height, new JTextField().getPreferredSize().height));
  }
}
