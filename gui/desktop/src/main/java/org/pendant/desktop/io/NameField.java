package org.pendant.desktop.io;

import static org.pendant.desktop.io.IoTexts.text;

import java.awt.event.FocusAdapter;
import java.awt.event.FocusEvent;
import javax.swing.JTextField;
import org.pendant.kit.layout.TitledCard;

/** Name field: where people name a signal. */
final class NameField {
  private NameField() {}

  /**
   * A field with the name of a signal.
   *
   * @param id of the signal, see {@link SignalName}
   * @param signal what it is called besides
   */
  static JTextField of(SignalLabels labels, String id, String signal) {
    JTextField field =
        TitledCard.named(new JTextField(labels.of(id)), id + "-label", text("yourNameFor", signal));
    field.putClientProperty("JTextField.placeholderText", text("nameHint"));
    field.putClientProperty(
        "FlatLaf.style", "borderColor: $Card.fieldBorder; background: null; arc: 8");
    labels.addListener(
        () -> {
          if (!field.getText().equals(labels.of(id)) && !field.isFocusOwner()) {
            field.setText(labels.of(id));
          }
        });
    field.addActionListener(event -> labels.name(id, field.getText()));
    field.addFocusListener(
        new FocusAdapter() {
          @Override
          public void focusLost(FocusEvent event) {
            labels.name(id, field.getText());
            field.setText(labels.of(id));
          }
        });
    return field;
  }
}
