/**
 * The form of the files that PolyScope saves: XML, mostly compressed, in which an element can stand
 * for another one by a reference. Open {@link org.pendant.project.polyscope.xml.PackedXml} first.
 */
package org.pendant.project.polyscope.xml;
