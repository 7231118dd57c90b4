package org.pendant.desktop.cell;

import java.awt.event.ActionEvent;
import java.awt.event.FocusAdapter;
import java.awt.event.FocusEvent;
import java.io.ByteArrayInputStream;
import java.nio.charset.StandardCharsets;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Set;
import java.util.stream.Collectors;
import javax.swing.AbstractAction;
import javax.swing.JComponent;
import javax.swing.JScrollPane;
import javax.swing.JTextArea;
import javax.swing.KeyStroke;
import javax.swing.UIManager;
import org.pendant.controller.box.EquipmentReader;
import org.pendant.desktop.session.SceneDraft;
import org.pendant.kit.form.Remark;
import org.pendant.kit.layout.TitledCard;
import org.pendant.kit.layout.Typed;
import org.pendant.kit.theme.Palette;
import org.pendant.models.json.JsonException;
import org.pendant.models.json.JsonMembers;
import org.pendant.models.json.JsonValues;

/**
 * Equipment card: devices and rules as text, checked while it is typed and taken with Ctrl+Enter or
 * when the focus leaves.
 */
final class EquipmentCard {
  private static final Set<String> KEYS = Set.of("devices", "rules");
  private static final String FILE = "text";
  private static final int ROWS = 12;

  private final SceneDraft draft;
  private final TitledCard card = new TitledCard("Devices and rules", "[grow, fill]");
  private final JTextArea area = new JTextArea(ROWS, 30);
  private final Remark problem = new Remark("cell-equipment-problem", Palette::error);
  private Map<String, String> shown = Map.of();
  private boolean showing;

  EquipmentCard(SceneDraft draft) {
    this.draft = draft;
    TitledCard.named(area, "cell-equipment", "Devices and rules of the cell, as JSON");
    area.setFont(UIManager.getFont("monospaced.font"));
    area.getDocument().addDocumentListener(new Typed(this::check));
    area.addFocusListener(
        new FocusAdapter() {
          @Override
          public void focusLost(FocusEvent event) {
            take();
          }
        });
    area.getInputMap().put(KeyStroke.getKeyStroke("control ENTER"), "take");
    area.getActionMap()
        .put(
            "take",
            new AbstractAction() {
              @Override
              public void actionPerformed(ActionEvent event) {
                take();
              }
            });
    Remark help = new Remark("cell-equipment-help", Palette::quiet);
    help.say(
        "Grippers, doors, sensors, and what happens by itself, as docs/devices.md has them; taken"
            + " with Ctrl+Enter.");
    card.add(new JScrollPane(area), "grow, hmin 120");
    card.add(problem, Remark.LAYOUT);
    card.add(help, Remark.LAYOUT);
  }

  JComponent component() {
    return card;
  }

  /** Shows the draft; what is being typed in place of the same stays. */
  void show() {
    Map<String, String> now = draft.equipment();
    if (!now.equals(shown) || area.getText().isEmpty()) {
      shown = new LinkedHashMap<>(now);
      showing = true;
      area.setText(text(now));
      area.setCaretPosition(0);
      showing = false;
      problem.say("");
    }
  }

  private static String text(Map<String, String> members) {
    return members.entrySet().stream()
        .map(each -> "  " + JsonValues.text(each.getKey()) + ": " + each.getValue())
        .collect(Collectors.joining(",\n", "{\n", "\n}\n"));
  }

  private void check() {
    if (!showing) {
      problem.say(refusal());
    }
  }

  /** What is wrong with the text, with its line and column; empty if nothing is. */
  private String refusal() {
    String text = area.getText();
    try {
      var _ =
          EquipmentReader.read(
              FILE, new ByteArrayInputStream(text.getBytes(StandardCharsets.UTF_8)));
    } catch (JsonException e) {
      return e.getMessage().replaceFirst("^" + FILE + ":(\\d+):(\\d+): ", "line $1, column $2: ");
    }
    return JsonMembers.of(text).keySet().stream()
        .filter(each -> !KEYS.contains(each))
        .findFirst()
        .map(each -> each + " is no part of this text, which may have devices and rules")
        .orElse("");
  }

  private void take() {
    if (refusal().isEmpty()) {
      Map<String, String> members = JsonMembers.of(area.getText());
      shown = members;
      draft.setEquipment(members);
    }
  }
}
