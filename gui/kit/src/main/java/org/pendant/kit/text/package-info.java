/** What others have said in English, in the language of the window. */
package org.pendant.kit.text;
