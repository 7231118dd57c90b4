package org.pendant.desktop.help;

import java.util.List;
import java.util.Map;
import org.commonmark.Extension;
import org.commonmark.ext.gfm.tables.TableCell;
import org.commonmark.ext.gfm.tables.TablesExtension;
import org.commonmark.ext.heading.anchor.HeadingAnchorExtension;
import org.commonmark.node.AbstractVisitor;
import org.commonmark.node.HtmlBlock;
import org.commonmark.node.Image;
import org.commonmark.node.Node;
import org.commonmark.parser.Parser;
import org.commonmark.renderer.html.HtmlRenderer;

/** Markdown as HTML that a text component can show: without pictures, every heading with an id. */
final class Markdown {
  private Markdown() {}

  /** A page without its head. */
  static String html(String markdown) {
    List<Extension> extensions = List.of(TablesExtension.create(), HeadingAnchorExtension.create());
    Node page = Parser.builder().extensions(extensions).build().parse(markdown);
    page.accept(new NoPictures());
    page.accept(new NoRemarks());
    return HtmlRenderer.builder()
        .extensions(extensions)
        .attributeProviderFactory(context -> Markdown::alignCells)
        .escapeHtml(true)
        .build()
        .render(page);
  }

  /** Style sheets of text components do not align cells. */
  private static void alignCells(Node node, String tag, Map<String, String> attributes) {
    if (node instanceof TableCell) {
      attributes.put("valign", "top");
      attributes.putIfAbsent("align", "left");
    }
  }

  /** They are not packaged with the program. */
  private static final class NoPictures extends AbstractVisitor {
    @Override
    public void visit(Image image) {
      Node paragraph = image.getParent();
      image.unlink();
      if (paragraph.getFirstChild() == null) {
        paragraph.unlink();
      }
    }
  }

  /** What a page says to the build, such as why a block is not run. */
  private static final class NoRemarks extends AbstractVisitor {
    @Override
    public void visit(HtmlBlock block) {
      if (block.getLiteral().startsWith("<!--")) {
        block.unlink();
      }
    }
  }
}
