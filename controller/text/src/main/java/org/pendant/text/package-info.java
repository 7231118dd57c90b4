/** Texts for people, by key, in the languages that there are. */
package org.pendant.text;
