package org.pendant.desktop.help;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.function.Function;
import java.util.stream.Stream;
import org.commonmark.Extension;
import org.commonmark.ext.gfm.tables.TablesExtension;
import org.commonmark.ext.heading.anchor.IdGenerator;
import org.commonmark.node.AbstractVisitor;
import org.commonmark.node.Code;
import org.commonmark.node.Heading;
import org.commonmark.node.Node;
import org.commonmark.node.Text;
import org.commonmark.parser.Parser;
import org.commonmark.renderer.text.LineBreakRendering;
import org.commonmark.renderer.text.TextContentRenderer;
import org.pendant.kit.text.Messages;

/** Help search: finds sections of the help by words that are in them. */
final class HelpSearch {
  /** More nobody reads. */
  private static final int MAX_HITS = 60;

  private final List<Section> sections = new ArrayList<>();

  /**
   * What was found.
   *
   * @param heading of the section
   * @param place the id of the heading on the page
   */
  record Hit(HelpPage page, String heading, String place) {
    @Override
    public String toString() {
      return heading.equals(page.title()) ? heading : Messages.told(page.title(), heading);
    }
  }

  /** A heading with the text up to the next one, in small letters. */
  private record Section(Hit hit, String text) {
    boolean has(String word) {
      return text.contains(word) || heading().contains(word);
    }

    String heading() {
      return hit.toString().toLowerCase(Locale.ROOT);
    }

    /** Less for what is more likely meant: first where the headings have the words. */
    int rank(List<String> words) {
      return (int) words.stream().filter(word -> !heading().contains(word)).count();
    }
  }

  /** For these pages, with the text of each; it takes a while. */
  HelpSearch(List<HelpPage> pages, Function<HelpPage, String> textOf) {
    pages.forEach(page -> add(page, textOf.apply(page)));
  }

  private void add(HelpPage page, String markdown) {
    List<Extension> tables = List.of(TablesExtension.create());
    TextContentRenderer plain =
        TextContentRenderer.builder()
            .extensions(tables)
            .lineBreakRendering(LineBreakRendering.STRIP)
            .build();
    IdGenerator ids = IdGenerator.builder().build();
    Hit hit = new Hit(page, page.title(), "");
    StringBuilder text = new StringBuilder();
    Node root = Parser.builder().extensions(tables).build().parse(markdown);
    for (Node node = root.getFirstChild(); node != null; node = node.getNext()) {
      if (node instanceof Heading) {
        keep(hit, text);
        String words = Words.of(node);
        hit = new Hit(page, words, ids.generateId(words));
      } else {
        text.append(plain.render(node)).append('\n');
      }
    }
    keep(hit, text);
  }

  /** The words of a heading, of which its id on the page is made. */
  private static final class Words extends AbstractVisitor {
    private final StringBuilder words = new StringBuilder();

    static String of(Node heading) {
      Words visitor = new Words();
      heading.accept(visitor);
      return visitor.words.toString();
    }

    @Override
    public void visit(Text text) {
      words.append(text.getLiteral());
    }

    @Override
    public void visit(Code code) {
      words.append(code.getLiteral());
    }
  }

  private void keep(Hit hit, StringBuilder text) {
    if (!text.isEmpty()) {
      sections.add(new Section(hit, text.toString().toLowerCase(Locale.ROOT)));
      text.setLength(0);
    }
  }

  /** The sections that have all words of {@code query}, the likeliest first. */
  List<Hit> find(String query) {
    List<String> words =
        Stream.of(query.toLowerCase(Locale.ROOT).split("\\s+"))
            .filter(word -> !word.isEmpty())
            .toList();
    return sections.stream()
        .filter(section -> words.stream().allMatch(section::has))
        .sorted(Comparator.comparingInt(section -> section.rank(words)))
        .map(Section::hit)
        .limit(MAX_HITS)
        .toList();
  }
}
