package org.pendant.desktop.editor;

import javax.swing.event.DocumentEvent;
import javax.swing.event.DocumentListener;
import javax.swing.text.BadLocationException;
import org.pendant.desktop.editor.text.Edit;
import org.pendant.desktop.editor.text.LineColours;
import org.pendant.desktop.editor.text.TextSpan;
import org.pendant.desktop.session.ProgramDocument;

/**
 * Document link: keeps a text component and the document of a program the same, whichever is
 * changed.
 */
final class DocumentLink implements DocumentListener, ProgramDocument.Listener {
  private final ScriptArea area;
  private final ProgramDocument program;
  private final LineColours colours;
  private final Runnable changed;
  private boolean passingOn;
  private boolean gathering;

  /**
   * Fills {@code area} and begins to pass changes on.
   *
   * @param changed told after every change of the text
   */
  DocumentLink(ScriptArea area, ProgramDocument program, LineColours colours, Runnable changed) {
    this.area = area;
    this.program = program;
    this.colours = colours;
    this.changed = changed;
    area.setText(program.text());
    area.setCaretPosition(0);
    area.discardAllEdits();
    area.getDocument().addDocumentListener(this);
    program.addListener(this);
  }

  /** Does {@code edits} and passes them on as one, which is faster for hundreds of them. */
  void gather(Runnable edits) {
    gathering = true;
    edits.run();
    gathering = false;
    passingOn = true;
    program.setText(area.getText());
    passingOn = false;
    changed.run();
  }

  /** Forgets both. */
  void end() {
    area.getDocument().removeDocumentListener(this);
    program.removeListener(this);
  }

  @Override
  public void insertUpdate(DocumentEvent event) {
    try {
      String added = area.getDocument().getText(event.getOffset(), event.getLength());
      changed(event, 0, added);
    } catch (BadLocationException e) {
      throw new IllegalStateException("what came is not in the text", e);
    }
  }

  @Override
  public void removeUpdate(DocumentEvent event) {
    changed(event, event.getLength(), "");
  }

  @Override
  public void changedUpdate(DocumentEvent event) {}

  private void changed(DocumentEvent event, int removed, String added) {
    DocumentEvent.ElementChange lines =
        event.getChange(event.getDocument().getDefaultRootElement());
    if (lines != null) {
      colours.moved(
          lines.getIndex(),
          lines.getChildrenRemoved().length - 1,
          lines.getChildrenAdded().length - 1);
    }
    if (gathering) {
      return;
    }
    if (!passingOn) {
      passingOn = true;
      program.replace(event.getOffset(), removed, added);
      passingOn = false;
    }
    changed.run();
  }

  @Override
  public void textChanged(int offset, int removed, String added) {
    if (!passingOn) {
      passingOn = true;
      boolean empty = area.getDocument().getLength() == 0;
      Edit edit = Edit.difference(offset, area.text(new TextSpan(offset, offset + removed)), added);
      area.replaceRange(edit.text(), edit.span().start(), edit.span().end());
      if (empty) {
        // a caret at the only place there was would go to the end with what comes
        area.setCaretPosition(0);
      }
      passingOn = false;
    }
  }
}
