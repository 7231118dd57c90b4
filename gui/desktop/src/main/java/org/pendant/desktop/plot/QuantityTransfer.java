package org.pendant.desktop.plot;

import static org.pendant.desktop.plot.PlotTexts.text;

import java.awt.datatransfer.DataFlavor;
import java.awt.datatransfer.StringSelection;
import java.awt.datatransfer.Transferable;
import java.awt.datatransfer.UnsupportedFlavorException;
import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.Supplier;
import java.util.stream.Collectors;
import javax.swing.JComponent;
import javax.swing.TransferHandler;

/**
 * Quantity transfer: carries quantities from the list to a chart, as text with their ids. A chart
 * also takes the name of a script variable as plain text, from wherever it was dragged.
 */
@SuppressWarnings("serial") // never written to a stream
final class QuantityTransfer extends TransferHandler {
  private static final String MARK = "pendant-quantities:";

  private final ChartQuantities quantities;
  private final Supplier<List<ChartQuantity>> dragged;
  private final Optional<Consumer<List<ChartQuantity>>> dropped;

  private QuantityTransfer(
      ChartQuantities quantities,
      Supplier<List<ChartQuantity>> dragged,
      Optional<Consumer<List<ChartQuantity>>> dropped) {
    this.quantities = quantities;
    this.dragged = dragged;
    this.dropped = dropped;
  }

  /** For what quantities are dragged from. */
  static QuantityTransfer from(ChartQuantities quantities, Supplier<List<ChartQuantity>> dragged) {
    return new QuantityTransfer(quantities, dragged, Optional.empty());
  }

  /** For what they are dropped on. */
  static QuantityTransfer to(ChartQuantities quantities, Consumer<List<ChartQuantity>> dropped) {
    return new QuantityTransfer(quantities, List::of, Optional.of(dropped));
  }

  @Override
  public int getSourceActions(JComponent from) {
    return COPY;
  }

  @Override
  protected Transferable createTransferable(JComponent from) {
    String ids = dragged.get().stream().map(ChartQuantity::id).collect(Collectors.joining(","));
    return ids.isEmpty() ? null : new StringSelection(MARK + ids);
  }

  @Override
  public boolean canImport(TransferSupport support) {
    return dropped.isPresent() && support.isDataFlavorSupported(DataFlavor.stringFlavor);
  }

  @Override
  public boolean importData(TransferSupport support) {
    if (!canImport(support)) {
      return false;
    }
    List<ChartQuantity> found = read(support.getTransferable());
    if (!found.isEmpty()) {
      dropped.get().accept(found);
    }
    return !found.isEmpty();
  }

  private List<ChartQuantity> read(Transferable carried) {
    List<ChartQuantity> found = new ArrayList<>();
    try {
      String text = (String) carried.getTransferData(DataFlavor.stringFlavor);
      if (!text.startsWith(MARK)) {
        return quantities.variables().of(text);
      }
      for (String id : text.substring(MARK.length()).split(",", -1)) {
        quantities.find(id).ifPresent(found::add);
      }
    } catch (UnsupportedFlavorException | IOException e) {
      // the source that offered a text has none any more: nothing was dropped
      return List.of();
    }
    return found;
  }
}
