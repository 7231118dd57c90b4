package org.pendant.desktop.help;

import static org.pendant.desktop.help.HelpViewTexts.text;

import com.formdev.flatlaf.util.UIScale;
import java.awt.Component;
import java.awt.Dimension;
import java.awt.EventQueue;
import java.awt.Rectangle;
import java.awt.event.ActionEvent;
import java.io.IOException;
import java.io.StringReader;
import java.io.UncheckedIOException;
import java.util.Map;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.Function;
import java.util.stream.Collectors;
import javax.swing.AbstractAction;
import javax.swing.DefaultListCellRenderer;
import javax.swing.DefaultListModel;
import javax.swing.JButton;
import javax.swing.JComponent;
import javax.swing.JEditorPane;
import javax.swing.JList;
import javax.swing.JPanel;
import javax.swing.JScrollPane;
import javax.swing.JTextField;
import javax.swing.KeyStroke;
import javax.swing.ListSelectionModel;
import javax.swing.event.HyperlinkEvent;
import javax.swing.text.AttributeSet;
import javax.swing.text.BadLocationException;
import javax.swing.text.Document;
import javax.swing.text.Element;
import javax.swing.text.html.HTML;
import javax.swing.text.html.HTMLDocument;
import javax.swing.text.html.HTMLEditorKit;
import net.miginfocom.swing.MigLayout;
import org.pendant.kit.background.Background;
import org.pendant.kit.layout.Typed;
import org.pendant.kit.theme.Overlay;
import org.pendant.kit.theme.Palette;

/** Help panel: the pages of the help, over the views. */
final class HelpPanel {
  private static final Dimension USUAL = new Dimension(960, 620);

  private final Function<HelpPage, String> made;
  private final Consumer<String> outside;
  private final DefaultListModel<HelpSearch.Hit> model = new DefaultListModel<>();
  private final JList<HelpSearch.Hit> list = new JList<>(model);
  private final JTextField query = new JTextField();
  private final JEditorPane text = new JEditorPane();
  private final Overlay overlay;
  private HelpPage shown = HelpPage.FIRST;
  private boolean choosing;
  private Optional<HelpSearch> search = Optional.empty();
  private boolean indexing;

  /**
   * A panel that is closed.
   *
   * @param under what it may cover
   * @param made the text of pages that the window makes itself; empty for other pages
   * @param outside takes links that lead to no page
   */
  HelpPanel(JComponent under, Function<HelpPage, String> made, Consumer<String> outside) {
    this.made = made;
    this.outside = outside;
    JPanel panel =
        new JPanel(
            new MigLayout(
                "insets 0, gap 12", "[230!, fill][grow, fill, 0::]", "[grow, fill, 0::][]"));
    panel.setOpaque(false);
    list.setName("help-pages");
    list.setCellRenderer(new WithTip());
    list.getAccessibleContext().setAccessibleName(text("pagesOfTheHelp"));
    list.setSelectionMode(ListSelectionModel.SINGLE_SELECTION);
    list.addListSelectionListener(
        event -> {
          if (!event.getValueIsAdjusting() && !choosing && list.getSelectedValue() != null) {
            show(list.getSelectedValue().page(), list.getSelectedValue().place());
          }
        });
    addQuery();
    text.setName("help-text");
    text.setEditable(false);
    addLinkKeys();
    text.addHyperlinkListener(
        event -> {
          if (event.getEventType() == HyperlinkEvent.EventType.ACTIVATED) {
            follow(event.getDescription());
          }
        });
    // A column of its own, so that Tab leads from the list to the text.
    JPanel pages = new JPanel(new MigLayout("insets 0, gap 8, wrap 1", "[grow, fill]"));
    pages.setOpaque(false);
    pages.add(query);
    pages.add(
        new JScrollPane(
            list, JScrollPane.VERTICAL_SCROLLBAR_AS_NEEDED, JScrollPane.HORIZONTAL_SCROLLBAR_NEVER),
        "grow, push");
    panel.add(pages);
    panel.add(new JScrollPane(text), "spany 2, wrap");
    panel.add(closeButton());
    panel.setPreferredSize(UIScale.scale(USUAL));
    overlay = new Overlay("help", under, panel);
    overlay.takeEscapeAnywhere();
  }

  /** Ctrl+T and Ctrl+Shift+T choose links already; the usual action knows no pages of the help. */
  private void addLinkKeys() {
    text.getInputMap().put(KeyStroke.getKeyStroke("ENTER"), "activate-link-action");
    text.getActionMap()
        .put(
            "activate-link-action",
            new AbstractAction() {
              @Override
              public void actionPerformed(ActionEvent event) {
                Element chosen =
                    ((HTMLDocument) text.getDocument())
                        .getCharacterElement(text.getSelectionStart());
                if (chosen.getAttributes().getAttribute(HTML.Tag.A) instanceof AttributeSet link
                    && link.getAttribute(HTML.Attribute.HREF) instanceof String target) {
                  follow(target);
                }
              }
            });
  }

  private void addQuery() {
    query.setName("help-search");
    query.putClientProperty("JTextField.placeholderText", text("searchTheHelp"));
    query.putClientProperty("JTextField.showClearButton", true);
    query.setToolTipText(text("wordsThatASectionHasThe"));
    query.getAccessibleContext().setAccessibleName(text("searchTheHelp"));
    query.getDocument().addDocumentListener(new Typed(this::find));
    query.registerKeyboardAction(
        event -> list.requestFocusInWindow(),
        KeyStroke.getKeyStroke("DOWN"),
        JComponent.WHEN_FOCUSED);
    query.addActionListener(event -> list.setSelectedIndex(0));
    listPages();
  }

  private void listPages() {
    model.clear();
    HelpPage.all().forEach(page -> model.addElement(new HelpSearch.Hit(page, page.title(), "")));
  }

  /** Lists what has the words that were typed; all pages while there are none. */
  private void find() {
    String words = query.getText();
    choosing = true;
    if (words.isBlank()) {
      listPages();
    } else if (search.isPresent()) {
      model.clear();
      model.addAll(search.get().find(words));
    } else if (!indexing) {
      indexing = true;
      index();
    }
    choosing = false;
  }

  /** Reads all pages, and then finds what has been typed until then. */
  private void index() {
    Map<HelpPage, String> own =
        HelpPage.all().stream().collect(Collectors.toMap(page -> page, made));
    Background.run(
        () ->
            new HelpSearch(
                HelpPage.all(),
                page -> own.get(page).isEmpty() ? HelpTexts.read(page.name()) : own.get(page)),
        read -> {
          search = Optional.of(read);
          find();
        },
        failed -> text.setText(failed.getMessage()));
  }

  private JButton closeButton() {
    JButton close = new JButton(text("close"));
    close.setName("help-close");
    close.setToolTipText(text("closesTheHelpEsc"));
    close.addActionListener(event -> close());
    return close;
  }

  /** Opens it at a page. */
  void open(HelpPage page) {
    query.setText("");
    overlay.open();
    show(page, "");
    list.requestFocusInWindow();
  }

  /** Closes it, if it is open. */
  void close() {
    overlay.close();
  }

  private void show(HelpPage page, String place) {
    shown = page;
    choosing = true;
    if (query.getText().isBlank()) {
      list.setSelectedValue(new HelpSearch.Hit(page, page.title(), ""), true);
    }
    choosing = false;
    // Reading the look and the keys is for this thread, the rest takes long for long pages.
    HTMLEditorKit kit = HelpStyle.kit();
    String own = made.apply(page);
    Background.run(
        () -> document(kit, own.isEmpty() ? HelpTexts.read(page.name()) : own),
        read -> take(page, place, kit, read),
        failed -> text.setText(failed.getMessage()));
  }

  private void take(HelpPage page, String place, HTMLEditorKit kit, Document read) {
    if (!page.equals(shown)) {
      return;
    }
    text.setEditorKit(kit);
    text.setDocument(read);
    // Each kind of text brings an accessible context of its own.
    text.getAccessibleContext().setAccessibleName(text("help"));
    text.setBackground(Palette.card());
    text.setCaretPosition(0);
    if (!place.isEmpty()) {
      EventQueue.invokeLater(() -> scrollTo(place));
    }
  }

  private void scrollTo(String heading) {
    Element found = ((HTMLDocument) text.getDocument()).getElement(heading);
    if (found == null) {
      return;
    }
    try {
      Rectangle place = text.modelToView2D(found.getStartOffset()).getBounds();
      place.height = text.getVisibleRect().height; // to the upper edge
      text.scrollRectToVisible(place);
      text.setCaretPosition(found.getStartOffset());
    } catch (BadLocationException e) {
      throw new IllegalStateException(e);
    }
  }

  private static Document document(HTMLEditorKit kit, String markdown) throws IOException {
    Document document = kit.createDefaultDocument();
    try {
      kit.read(
          new StringReader("<html><body>" + Markdown.html(markdown) + "</body></html>"),
          document,
          0);
    } catch (BadLocationException e) {
      throw new UncheckedIOException(new IOException(e));
    }
    return document;
  }

  private void follow(String link) {
    if (link.contains(":")) {
      outside.accept(link);
      return;
    }
    String name = shown.target(link);
    String place = link.contains("#") ? link.substring(link.indexOf('#') + 1) : "";
    if (name.equals(shown.name()) && !place.isEmpty()) {
      scrollTo(place);
      return;
    }
    Optional<HelpPage> listed =
        HelpPage.all().stream().filter(each -> each.name().equals(name)).findFirst();
    if (listed.isPresent()) {
      show(listed.get(), place);
    } else if (name.endsWith(".md") && HelpTexts.find(name).isPresent()) {
      show(new HelpPage(name, name), place);
    } else {
      outside.accept(name);
    }
  }

  /** What is too long for the list is whole in its tip. */
  @SuppressWarnings("serial") // never written to a stream
  private static final class WithTip extends DefaultListCellRenderer {
    @Override
    public Component getListCellRendererComponent(
        JList<?> list, Object value, int index, boolean selected, boolean focused) {
      super.getListCellRendererComponent(list, value, index, selected, focused);
      setToolTipText(value.toString());
      return this;
    }
  }
}
