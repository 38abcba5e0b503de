#include "latex_parts.hpp"

namespace boxbeam::report {

const char* const latex_preamble = R"(\documentclass[a4paper,10pt]{article}
\usepackage[T1]{fontenc}
\usepackage[utf8]{inputenc}
\usepackage{textcomp}
\usepackage{lmodern}
% One design size of each face for all sizes, and one bold face: they are most of a report's bytes.
\DeclareFontFamily{T1}{lmr}{}
\DeclareFontShape{T1}{lmr}{m}{n}{<->ec-lmr9}{}
\DeclareFontShape{T1}{lmr}{m}{it}{<->ec-lmri9}{}
\DeclareFontShape{T1}{lmr}{bx}{n}{<->ec-lmssbx10}{}
\DeclareFontShape{T1}{lmr}{b}{n}{<->ssub*lmr/bx/n}{}
\DeclareFontFamily{T1}{lmss}{}
\DeclareFontShape{T1}{lmss}{m}{n}{<->ec-lmss10}{}
\DeclareFontShape{T1}{lmss}{bx}{n}{<->ec-lmssbx10}{}
\DeclareFontShape{T1}{lmss}{b}{n}{<->ssub*lmss/bx/n}{}
\DeclareFontFamily{TS1}{lmss}{}
\DeclareFontShape{TS1}{lmss}{m}{n}{<->ts1-lmss10}{}
\DeclareFontShape{TS1}{lmss}{bx}{n}{<->ts1-lmssbx10}{}
\DeclareFontFamily{TS1}{lmr}{}
\DeclareFontShape{TS1}{lmr}{m}{n}{<->ts1-lmr9}{}
\DeclareFontShape{TS1}{lmr}{bx}{n}{<->ts1-lmssbx10}{}
\DeclareFontFamily{OT1}{lmr}{}
\DeclareFontShape{OT1}{lmr}{m}{n}{<->rm-lmr9}{}
\DeclareFontShape{OT1}{lmr}{bx}{n}{<->rm-lmbx9}{}
\DeclareFontFamily{OML}{lmm}{}
\DeclareFontShape{OML}{lmm}{m}{it}{<->lmmi9}{}
\DeclareFontShape{OML}{lmm}{b}{it}{<->lmmib10}{}
\DeclareFontFamily{OMS}{lmsy}{}
\DeclareFontShape{OMS}{lmsy}{m}{n}{<->lmsy9}{}
\DeclareFontShape{OMS}{lmsy}{b}{n}{<->lmbsy10}{}
\usepackage[a4paper,left=24mm,textwidth=468pt,top=24mm,bottom=21mm,headsep=6mm,footskip=10mm]{geometry}
\usepackage{amsmath}
\usepackage{array}
\usepackage{booktabs}
\usepackage{longtable}
\usepackage{graphicx}
\usepackage{xcolor}

% The same input gives the same bytes; figures of other programs may be PDF up to 1.7.
\pdfsuppressptexinfo=15
\pdftrailerid{}
\pdfminorversion=7
\pdfinclusionerrorlevel=0

\definecolor{fails}{HTML}{B3121D}
\definecolor{passes}{HTML}{1B6B3A}
\definecolor{unknown}{HTML}{8A5A00}
\definecolor{plain}{HTML}{3C4048}
\definecolor{quiet}{HTML}{5F6368}
\definecolor{pale}{HTML}{D9DCE1}

\setlength{\parindent}{0pt}
\setlength{\parskip}{4pt plus 1pt}
\setlength{\emergencystretch}{6em}
\setlength{\LTpre}{6pt}
\setlength{\LTpost}{8pt}
\setlength{\tabcolsep}{0pt}
\renewcommand{\arraystretch}{1.02}
\raggedbottom
\clubpenalty=10000
\widowpenalty=10000
\allowdisplaybreaks
\vbadness=10000
\setcounter{secnumdepth}{0}

% A backslash inside a string of the PDF.
\begingroup\catcode`\|=0 \catcode`\\=12 |gdef|B{\}|endgroup

% A sign that is copied from the PDF as the code point it was, whatever glyph shows it.
\newcommand{\as}[2]{\pdfliteral direct{/Span<</ActualText<FEFF#1>>>BDC}#2\pdfliteral direct{EMC}}

% Where a long word may break: after punctuation, and where nothing else helps.
\newcommand{\brk}{\penalty0\hskip0pt\relax}
\newcommand{\Brk}{\penalty500\hskip0pt\relax}
\newcommand{\Left}{\raggedright\arraybackslash\hskip0pt\relax}
\newcommand{\Right}{\raggedleft\arraybackslash\hskip0pt\relax}

% A new page where so much height is not left; never between a heading and what it heads.
\makeatletter
\newcommand{\need}[1]{\par\if@nobreak\@nobreakfalse\else\penalty0\relax
  \ifdim\pagetotal>0pt
    \ifdim\dimexpr\pagegoal-\pagetotal\relax<\dimexpr#1\relax\newpage\fi
  \fi\fi}
\makeatother

% Head and foot of the pages; the second run knows how many there are.
\providecommand{\lastpage}{?}
\makeatletter
\newcommand{\ps@report}{%
  \def\@oddhead{\vbox{\hsize\textwidth\hbox to\textwidth{\sffamily\footnotesize\color{quiet}\headleft\hfil\headright}%
    \vskip3pt{\color{pale}\hrule height.4pt}}}%
  \def\@oddfoot{\hbox to\textwidth{\sffamily\footnotesize\color{quiet}\footleft\hfil page \thepage{} of \lastpage}}}
\renewcommand{\section}{\@startsection{section}{1}{0pt}{\ifshort-12pt\else-16pt plus -4pt\fi}{\ifshort3pt\else6pt\fi}{\sffamily\bfseries\Large\raggedright}}
\renewcommand{\subsection}{\@startsection{subsection}{2}{0pt}{\ifshort-7pt\else-9pt plus -2pt\fi}{\ifshort1pt\else3pt\fi}{\sffamily\bfseries\normalsize\raggedright}}
\AtEndDocument{\clearpage\immediate\write\@auxout{\gdef\string\lastpage{\the\numexpr\value{page}-1\relax}}}
\makeatother

% \chapter{number}{title}{title as a string of the PDF}
\newcommand{\chapterline}[3]{\section{\hbox to0pt{\pdfdest name{c#1} xyz\hss}#1\hskip0.8em #2}%
  \pdfoutline goto name{c#1} count 0{#3}\label{c#1}\nopagebreak}
\newcommand{\contentsentry}[2]{\hbox to.47\linewidth{\pdfstartlink attr{/Border[0 0 0]} goto name{c#1}%
  \hbox to1.6em{#1\hfil}#2\ \color{pale}\leaders\hbox to.6em{\hss.\hss}\hfil\ \color{black}\pageref{c#1}\pdfendlink}}

\newcommand{\tablecaption}[1]{\par\vskip6pt{\raggedright\noindent\sffamily\footnotesize\color{quiet}\hskip0pt#1\par}\nopagebreak\vskip-2pt}

% A drawing of the program's own: NAME.tex beside the report, else any other file that can be shown. It is
% as wide as the text where it is 620 wide.
\newcommand{\figurefile}[1]{\InputIfFileExists{#1.tex}{\unskip}{\includegraphics{#1}}}
\newenvironment{drawing}[2]{\unitlength=.75484pt\sffamily\fontsize{12\unitlength}{12\unitlength}\selectfont
  \begin{picture}(#1,#2)\ignorespaces}{\end{picture}}
\newcommand{\strokes}[1]{\put(0,0){\pdfliteral{q .75202 0 0 .75202 0 0 cm 1 J 1 j #1 Q}}\ignorespaces}
% \words{x}{y}{side}{colour}{text}
\newcommand{\words}[5]{\put(#1,#2){\color[HTML]{#4}\hbox to0pt{\ifx#3l\else\hss\fi#5\ifx#3r\else\hss\fi}}\ignorespaces}
\newcommand{\run}[3]{\raise#1\unitlength\hbox{\fontsize{#2\unitlength}{#2\unitlength}\selectfont#3}}

% A figure, never larger than it is, and somewhat smaller where that fits the page. Where it does not,
% it waits: what follows in its chapter may fill the page before it.
% \takefigure{file}{height of what comes with it}{caption}
\newsavebox{\figurebox}
\newif\ifwaiting
\newif\iffits
\makeatletter
\newdimen\figureleast
\newcommand{\lowerfigure}[1]{\ifdim\ht\figurebox>#1\setbox\figurebox\hbox{\resizebox{!}{#1}{\box\figurebox}}\fi}
\newcommand{\loadfigure}[2]{\def\figureextra{#2}\setbox\figurebox\hbox{\figurefile{#1}}%
  \ifdim\wd\figurebox>\linewidth\setbox\figurebox\hbox{\resizebox{\linewidth}{!}{\box\figurebox}}\fi
  \lowerfigure{.7\textheight}\figureleast=.85\ht\figurebox
  \ifdim\figureleast>.4\textheight\lowerfigure{\figureleast}\else\lowerfigure{.4\textheight}\fi}
\newcommand{\findroom}{\par\if@nobreak\else\penalty0\fi
  \dimen0=\dimexpr\ifdim\pagetotal>0pt\pagegoal-\pagetotal\else\textheight\fi\relax}
% Whether there is room for the figure, which may become somewhat smaller.
\newcommand{\fitfigure}{\findroom\advance\dimen0-\dimexpr\figureextra+1pt\relax
  \fitstrue\ifdim\ht\figurebox>\dimen0
    \ifdim\figureleast>\dimen0 \fitsfalse\else\lowerfigure{\dimen0}\fi\fi}
\newcommand{\takefigure}[3]{\loadfigure{#1}{#2}\def\figurecaption{#3}\waitingtrue
  \fitfigure\iffits\showfigure\fi}
% Before a block of this height the figure that waits, where there is room, or not for both.
\newcommand{\beforeblock}[1]{\ifwaiting
  \fitfigure\iffits\showfigure\else
    \findroom\ifdim\dimen0<\dimexpr#1\relax
      \newpage\fitfigure\showfigure
  \fi\fi\fi}
% As \need for a figure with what comes with it, or what may stand before it.
\newcommand{\needfigure}[3]{\par\if@nobreak\@nobreakfalse\else
  \loadfigure{#1}{#2}\fitfigure\iffits\else
    \findroom\ifdim\dimen0<\dimexpr#3\relax\newpage\fi\fi\fi}
\makeatother
\newcommand{\captionlines}[1]{{\leftskip=0pt plus 1fil\rightskip=0pt plus 1fil\parfillskip=0pt\noindent
  \sffamily\footnotesize\color{quiet}#1\par}}
\newcount\figurenumber
\newcommand{\numbered}[1]{\textbf{Figure #1.} }
\newcommand{\showfigure}{\waitingfalse\advance\figurenumber by 1
  \vskip6pt\hbox to\linewidth{\hfil\box\figurebox\hfil}\nopagebreak\vskip4pt
  \hbox to\linewidth{\hfil\vtop{\hsize=\dimexpr\linewidth-4em\relax\captionlines{\numbered{\the\figurenumber}\figurecaption}}\hfil}\vskip8pt}
% Two figures abreast, somewhat lower where that fits the page: \figurepair{file}{caption}{file}{caption}
\newdimen\halfheight
\newcommand{\halffigure}[1]{\setbox0\hbox{\figurefile{#1}}%
  \ifdim\wd0>.485\linewidth\setbox0\hbox{\resizebox{.485\linewidth}{!}{\box0}}\fi
  \ifdim\ht0>\halfheight\setbox0\hbox{\resizebox{!}{\halfheight}{\box0}}\fi
  \hbox to.485\linewidth{\hfil\box0\hfil}}
\newcommand{\halfcaption}[1]{\vtop{\hsize=.485\linewidth\captionlines{#1}}}
\newcommand{\figurepair}[4]{\findroom\advance\figurenumber by 2
  \setbox4\hbox to\linewidth{\halfcaption{\numbered{\number\numexpr\figurenumber-1\relax}#2}%
    \hfil\halfcaption{\numbered{\the\figurenumber}#4}}%
  \halfheight=\dimexpr\dimen0-\ht4-\dp4-22pt\relax
  \ifdim\halfheight<.19\textheight\halfheight=\maxdimen\fi
  % Of a short report two pairs share a page with what stands above them.
  \ifdim\halfheight>\ifshort.22\else.26\fi\textheight\halfheight=\ifshort.22\else.26\fi\textheight\fi
  \setbox2\vbox{\hbox to\linewidth{\halffigure{#1}\hfil\halffigure{#3}}\vskip4pt\box4}%
  \need{\dimexpr\ht2+\dp2+6pt\relax}\vskip6pt\box2\vskip6pt}
)"
                                   R"(
% A calculation sheet: a frame that goes on over pages, its left side in the colour of the result.
\newsavebox{\sheetbox}
\newcommand{\sheetpart}{\hbox{{\color{\sheetcolour}\vrule width2.5pt}\vbox{{\color{pale}\hrule height.5pt}%
  \hbox to\dimexpr\textwidth-3pt\relax{\hskip8pt\vbox{\vskip4pt\unvbox2\vskip4pt}\hss{\color{pale}\vrule width.5pt}}%
  {\color{pale}\hrule height.5pt}}}}
\makeatletter
\newcommand{\sheetrest}{%
  \dimen0=\dimexpr\ifdim\pagetotal>0pt\pagegoal\else\textheight\fi-\pagetotal-16pt\relax
  \ifdim\dimexpr\ht\sheetbox+\dp\sheetbox\relax<\dimen0
    \setbox2\vbox{\unvbox\sheetbox}\sheetpart\vskip8pt
  \else
    \splittopskip=8pt\splitmaxdepth=0pt\vfuzz=\maxdimen
    \setbox4\copy\sheetbox
    \setbox2\vsplit\sheetbox to\dimen0\setbox2\vbox{\unvbox2}%
    \ifdim\ht2>\dimen0\ifdim\pagetotal>0pt % no break so early: all of it on the next page
      \setbox\sheetbox\box4\setbox2\box\voidb@x\fi\fi
    \ifvoid2\else\sheetpart\fi
    \newpage\null\vskip-\baselineskip\penalty0\sheetrest
  \fi}
\makeatother
\newenvironment{sheet}[1]{\par\def\sheetcolour{#1}\sheetindent=0pt
  \setbox\sheetbox\vbox\bgroup\hsize=\dimexpr\textwidth-20pt\relax\linewidth=\hsize\textwidth=\hsize
  \columnwidth=\hsize\parskip=0pt\footnotesize\lineskip=1pt\lineskiplimit=.5pt\relax}
 {\par\egroup\vskip4pt\sheetrest}
\newcommand{\sheethead}[3]{\hbox to\linewidth{\vtop{\hsize=.78\linewidth\raggedright\sffamily\bfseries#1\par
  \normalfont\sffamily\scriptsize\color{quiet}#2}\hfil{\sffamily\bfseries\color{\sheetcolour}#3}}\nobreak\vskip1pt}
\newdimen\sheetindent
\newcommand{\widest}[1]{\setbox0\hbox{$\displaystyle#1$}\ifdim\wd0>.3\linewidth\else
  \ifdim\wd0>\sheetindent\sheetindent=\wd0\fi\fi}
% A step: its chain "symbol = formula = value  note" stands on one line as far as it fits, else it is
% broken before a "=" or a note; a formula too long for any line breaks at its signs. Box 4 is the
% line that is being filled.
\newif\ifbegun
\newcommand{\symbolof}[1]{\par\vskip2pt plus 1pt\begunfalse\setbox4\hbox{$\displaystyle#1$}%
  \ifdim\wd4>\sheetindent\hbox{\box4}\nobreak\emptyline\else
  \setbox4\hbox to\sheetindent{\hfil\unhbox4}\fi}
\newcommand{\emptyline}{\begunfalse\setbox4\hbox to\sheetindent{}}
\newcommand{\closeline}{\hbox{\box4}\nobreak\emptyline}
\newcommand{\equals}{\hbox to1.6em{\hfil$=$\hfil}}
\newcommand{\formula}[1]{\setbox0\hbox{\equals$\displaystyle#1$}%
  \ifbegun\ifdim\dimexpr\wd4+\wd0\relax>\linewidth\closeline\fi\fi
  \ifdim\dimexpr\wd4+\wd0\relax>\linewidth
    {\raggedright\hangindent=\dimexpr\sheetindent+1.6em\relax\hangafter=1\noindent\box4
      \equals$\displaystyle#1$\par}\nobreak\emptyline
  \else\setbox4\hbox{\box4\box0}\beguntrue\fi}
\newcommand{\note}[1]{\setbox0\hbox{{\scriptsize\color{quiet}#1}}%
  \ifbegun\ifdim\dimexpr\wd4+1.6em+\wd0\relax>\linewidth\closeline\fi\fi
  \ifdim\dimexpr\wd4+1.6em+\wd0\relax>\linewidth
    {\raggedright\leftskip=\dimexpr\sheetindent+1.6em\relax\noindent\scriptsize\color{quiet}#1\par}\nobreak
  \else\setbox4\hbox{\box4\hskip1.6em\box0}\beguntrue\fi}
\newcommand{\laststep}{\ifbegun\hbox{\box4}\fi\par}
% \result{text}{bar [mm], 34 are 100 %}{source}
\newcommand{\result}[3]{\par\nobreak\vskip4pt{\color{pale}\hrule height.4pt}\nobreak\vskip4pt
  \hbox to\linewidth{\vtop{\hsize=\dimexpr\linewidth-53mm\relax\raggedright\small\bfseries#1\par}\hfil
    \hbox to51mm{\rlap{\color{pale}\vrule width34mm height6pt}\rlap{\color{\sheetcolour}\vrule width#2mm height6pt}%
      \rlap{\hskip34mm\vrule width.7pt height8pt depth2pt\relax\raise-7pt\hbox to0pt{\hss\sffamily\tiny 100\,\%\hss}}\hss}}%
  \def\sheetsource{#3}\ifx\sheetsource\empty\else\nobreak\vskip1pt{\raggedright\noindent\scriptsize\color{quiet}#3\par}\fi}

\newif\ifshort
\newcommand{\bulletitem}[1]{{\parskip=2pt\small\leftskip=1.2em\relax\noindent\hbox to0pt{\hss\textbullet\hskip.5em}#1\par}}

% Names with what is said of each.
\newcommand{\fact}[3]{\hbox to\linewidth{\vtop{\hsize=#1\raggedright\noindent\color{quiet}\hskip0pt#2\par}\hskip1em\relax
  \vtop{\hsize=\dimexpr\linewidth-#1-1em\relax\raggedright\noindent\hskip0pt#3\par}\hss}\vskip2pt}

% The verdict, and the fields to sign.
\newcommand{\verdict}[2]{\vskip8pt\hbox{\fboxsep=7pt\colorbox{#1}{\vbox{\hsize=\dimexpr\textwidth-14pt\relax
  \raggedright\sffamily\bfseries\LARGE\color{white}\noindent\hskip0pt#2\par}}}\vskip6pt}
\newcommand{\signfield}[1]{\vtop{\hsize=.31\textwidth\noindent\sffamily\footnotesize\color{quiet}\strut#1\par\vskip20pt
  {\color{plain}\hrule height.4pt}\vskip3pt name, date, signature\par}}

% A line of a listing: its number, and what is too long goes on below.
\newcommand{\listingline}[2]{{\leftskip=2.6em\rightskip=0pt plus1fil\parskip=0pt\hangindent=2em\hangafter=1
  \noindent\hbox to0pt{\hss\color{quiet}#1\hskip1em}#2\par}}
)";

}  // namespace boxbeam::report
