package org.pendant.desktop.program.form;

import java.awt.Color;
import javax.swing.JComponent;
import org.pendant.kit.theme.Palette;

/** Note view: a sentence. */
final class NoteView implements FieldView {
  private final FormText text;
  private Item.Tone tone;

  NoteView(FieldViews views, Item.Note note) {
    tone = note.tone();
    text = new FormText(views.id(note.name()), this::color);
    show(note);
  }

  private Color color() {
    return switch (tone) {
      case QUIET -> Palette.quiet();
      case GOOD -> Palette.ok();
      case WARNING -> Palette.warning();
    };
  }

  @Override
  public JComponent component() {
    return text;
  }

  @Override
  public void show(Item shown) {
    Item.Note note = (Item.Note) shown;
    tone = note.tone();
    text.say(note.text());
  }
}
