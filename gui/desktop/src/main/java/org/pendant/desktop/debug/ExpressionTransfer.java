package org.pendant.desktop.debug;

import java.awt.datatransfer.DataFlavor;
import java.awt.datatransfer.StringSelection;
import java.awt.datatransfer.Transferable;
import java.awt.datatransfer.UnsupportedFlavorException;
import java.io.IOException;
import java.util.Optional;
import java.util.function.Consumer;
import javax.swing.JComponent;
import javax.swing.TransferHandler;

/**
 * Expression transfer: drags expressions out of tables of values, and into where they are taken.
 */
@SuppressWarnings("serial") // never written to a stream
final class ExpressionTransfer extends TransferHandler {
  private final Optional<Consumer<String>> taken;

  /** Hands what is dropped to {@code taken}; nothing can be dropped without. */
  ExpressionTransfer(Optional<Consumer<String>> taken) {
    this.taken = taken;
  }

  @Override
  public int getSourceActions(JComponent source) {
    return source instanceof ValueTable ? COPY : NONE;
  }

  @Override
  protected Transferable createTransferable(JComponent source) {
    return source instanceof ValueTable table
        ? table
            .selectedValue()
            .map(value -> new StringSelection(ValueTable.expression(value)))
            .orElse(null)
        : null;
  }

  @Override
  public boolean canImport(TransferSupport support) {
    return taken.isPresent() && support.isDataFlavorSupported(DataFlavor.stringFlavor);
  }

  @Override
  public boolean importData(TransferSupport support) {
    if (!canImport(support)) {
      return false;
    }
    try {
      Transferable dragged = support.getTransferable();
      taken.orElseThrow().accept((String) dragged.getTransferData(DataFlavor.stringFlavor));
      return true;
    } catch (UnsupportedFlavorException | IOException e) {
      // What is dragged has gone, or is no text after all: nothing is dropped.
      return false;
    }
  }
}
