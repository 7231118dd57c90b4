/**
 * The language that the command line speaks: English on every computer, since scripts read what it
 * prints, unless the environment asks for another. Open {@link
 * org.pendant.command.text.CommandLanguage} first.
 */
package org.pendant.command.text;
